// core/collide.hpp: all touching pairs of two sets.
//
// Two layers over the same decisions. pairs() works in the caller's memory, does not throw and answers a
// status. prepare() and collide() own their memory: a set is prepared once and collided often.
//
// A pair is decided where the closed boxes of its elements touch (the kind's box never is too small), by the
// predicate's rung; `certified` is several rungs, each on what the one before left unsure. A set against
// itself gives every ordered pair (i, j), i = j included. The same pairs come out for any number of threads
// and from either source of candidates.
#ifndef MEETC_CORE_COLLIDE_HPP
#define MEETC_CORE_COLLIDE_HPP

#include "core/ladder.hpp"
#include "core/memory.hpp"
#include "core/status.hpp"
#include "core/view.hpp"

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace meetc {

// ---- in the caller's memory ----

struct pairs_out {
  index_pair *data = nullptr; // null with capacity 0: only count
  std::size_t capacity = 0;
  std::uint64_t *count = nullptr; // the true count lands here, also where it exceeds the capacity
  rung_report *rungs = nullptr;   // null: not asked for
};

struct pairs_options {
  int threads = 0;            // 0: all cores; 1 starts no thread
  bool all_pairs = false;     // test every pair of boxes; no hierarchy is walked
  bool stop_at_first = false; // *count becomes 0 or 1, and no pair is written
  float box = 0;              // as in collide_options
  void (*progress)(void *context,
                   double fraction) noexcept = nullptr; // calling thread, about ten times a second
  void *progress_context = nullptr;
};

// Bytes that pairs() needs for so many elements on so many threads (0: all cores). Any alignment will do.
std::size_t workspace(const predicate_info &predicate, std::size_t elements_a, std::size_t elements_b, int threads = 0);

// All touching pairs (a, b), sorted by a, then b. Where *count > capacity, the pairs written are some of
// them, in no order: call again with more. Allocates nothing (but the system does for each thread that it
// starts). On any status but ok, *count is 0 and *rungs says nothing.
status pairs(const predicate_info &predicate, rung precision, const view &a, const pose &at_a, const view &b,
             const pose &at_b, pairs_out out, memory work, const pairs_options &options = {}) noexcept;

// ---- owning ----

// What prepare() throws for a bad element.
class input_error : public std::invalid_argument {
public:
  input_error(const fault &f, const kind_info &kind) : std::invalid_argument(describe(f, kind)), where(f) {}
  fault where;
};

struct element_set;

// A set that is ready to collide: packed rows, boxes, hierarchy. Immutable; may be used by several calls at
// once.
class prepared {
public:
  prepared(prepared &&) noexcept;
  prepared &operator=(prepared &&) noexcept;
  ~prepared();

  const kind_info &kind() const;
  std::size_t elements() const;
  // The box around all elements, finite; lo > hi for the empty set.
  void bounds(float lo[3], float hi[3]) const;
  const element_set &set() const { return *set_; }

private:
  friend prepared prepare(const view &, const kind_info &, const pose &, int);
  prepared();
  std::unique_ptr<std::byte[]> bytes_;
  std::unique_ptr<element_set> set_;
};

// Copies the elements under the pose. Throws input_error, std::invalid_argument (a kind that cannot be
// moved), std::length_error (too many elements) or std::bad_alloc.
prepared prepare(const view &elements, const kind_info &kind, const pose &at = {}, int threads = 0);

enum class collide_mode : std::uint8_t {
  list,  // count and pairs
  count, // count only; constant memory without owners
  any,   // count is 0 or 1; stops at the first hit
};

struct collide_options {
  collide_mode mode = collide_mode::list;
  int threads = 0;
  bool all_pairs = false;
  // The scene's (catalogue::box): coordinates lie in [-box, box], lengths in [0, 2 box]; 0: it has none. No
  // answer depends on it: where a set leaves it, the first rung of `certified` bounds each pair by itself.
  float box = 0;
  // Element -> item, of each side; empty: the element itself. Pairs are then of items, each once.
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  std::function<void(double fraction)> progress = {}; // on the calling thread, about ten times a second
};

struct result {
  std::vector<index_pair> pairs; // sorted by a, then b; no pair twice
  std::uint64_t count = 0;       // pairs, of items where there are owners
  std::uint64_t candidates = 0;  // pairs of elements that were decided
  rung_report rungs;             // the same for any number of threads, but for collide_mode::any
  double seconds = 0;
};

// Memory grows with the pairs, never with the product of the sets. Throws std::invalid_argument (kinds, rung,
// box or owners that do not fit) or std::bad_alloc.
result collide(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
               const collide_options &options = {});

} // namespace meetc

#endif
