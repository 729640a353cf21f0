// core/query/pairs.hpp: all touching pairs of two sets, in the caller's memory.
//
// pairs() works in memory that the caller lends; it does not throw and returns a status. The pairs are those of
// core/query/collide.hpp.
#ifndef MEETC_CORE_QUERY_PAIRS_HPP
#define MEETC_CORE_QUERY_PAIRS_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/views/memory.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/core/views/status.hpp"
#include "meet/core/views/view.hpp"

#include <stop_token>

namespace meetc {

// The destinations of the answers. A null pointer means that an answer is not wanted; only `count` is required.
struct pairs_out {
  index_pair *data = nullptr; // room for `capacity` pairs; null with capacity 0: only count
  std::size_t capacity = 0;
  std::uint64_t *count = nullptr; // becomes the true count, even where it exceeds the capacity
  rung_report *rungs = nullptr;
  // One number for each element: flags are 1 if it is in a pair and 0 if not; counts say in how many pairs it is.
  std::uint8_t *flags_a = nullptr, *flags_b = nullptr;
  std::uint64_t *counts_a = nullptr, *counts_b = nullptr;
};

struct pairs_options {
  int threads = 0;            // 0: all cores; 1 starts no thread
  bool stop_at_first = false; // *count becomes 0 or 1, no pair is written, and flags and counts stay 0
  float box = 0;              // as in collide_options
  // Called from the calling thread, about ten times a second, with a fraction from 0 to 1. May be null.
  void (*progress)(void *context, double fraction) noexcept = nullptr;
  void *progress_context = nullptr;
  std::stop_token stop = {}; // a request ends the call soon, with status::cancelled
};

// The bytes that pairs() needs for these numbers of elements and threads (0: all cores). Any alignment will do.
std::size_t workspace(const predicate_info &predicate, std::size_t elements_a, std::size_t elements_b, int threads = 0);

// All touching pairs (a, b), sorted by a, then b. Where *count > capacity, only some pairs are written, in no order:
// call again with more room. Allocates nothing (though the system does for each thread that it starts, and for the exception
// by which a request stops them). On any status but ok, *count is 0 and *rungs means nothing; the other arrays are unchanged,
// but where the status is `cancelled`: then they mean nothing.
status pairs(const predicate_info &predicate, rung precision, const view &a, const pose &at_a, const view &b,
             const pose &at_b, pairs_out out, memory work, const pairs_options &options = {}) noexcept;

} // namespace meetc

#endif
