// core/device/query/decide.hpp: walks, certifies and answers: which pairs of two sets on a device touch, part by part.
#ifndef MEETC_CORE_DEVICE_QUERY_DECIDE_HPP
#define MEETC_CORE_DEVICE_QUERY_DECIDE_HPP

#include "meet/core/device/answers/query_answer.hpp"
#include "meet/core/device/query/sieve.hpp"

#include <functional>
#include <memory>
#include <span>
#include <stop_token>

namespace meetc {

using device_answers = std::span<const std::unique_ptr<on_device::query_answer>>;

struct decision_job {
  const device &on;
  device_rows &a, &b; // with elements
  const cuda::predicate_launchers &by;
  rung precision;
  bool half;              // a and b are one set, and of each pair of elements one order is looked at
  device_answers answers; // which have started
  std::size_t list_capacity;
  const std::function<void(double fraction)> &progress;
  const std::stop_token &stop;
  bool counts_cleared; // in the device's buffers, for the first part
  // Where pairs are listed, and no walk decides: what is decided is what it keeps, and hits are listed one way. Null: all.
  candidate_sieve *sieve = nullptr;
  bool first_alone = false; // only what is met first is asked for, and segments go down alone to it, if they can
};

// Adds to r's count, candidates, unsure pairs and parts. Marks the clock behind the last kernel. Throws device_error or
// `cancelled`.
void decide_all(const decision_job &job, device_result &r);

} // namespace meetc

#endif
