// core/query/collide.hpp: which elements of two sets touch, as all pairs, counts, flags, or whether there is any.
//
// Two layers rest on the same decisions. prepare() and collide() own their memory: a set is prepared once and collided
// often. pairs(), in core/query/pairs.hpp, works in the caller's memory.
//
// A pair is decided where the closed boxes of its elements touch (the kind's box is never too small), by the predicate's rung;
// `certified` is several rungs, each for what the one before left unsure. For exact and certified an element with two hull
// points must also touch the other's box itself (core/hierarchy/two_points.hpp). A set against itself gives every ordered pair
// (i, j), i = j included. The answer is the same for any number of threads.
#ifndef MEETC_CORE_QUERY_COLLIDE_HPP
#define MEETC_CORE_QUERY_COLLIDE_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/query/pairs.hpp"
#include "meet/core/sets/prepared.hpp"

#include <functional>
#include <span>
#include <vector>

namespace meetc {

struct collide_options {
  answer_kind want = answer_kind::pairs;
  int threads = 0; // 0: all cores
  // Fill result::first_met as well, without a list. The predicate must know an order (predicate_info::first_met), the set a has
  // no owners, and `any` is not wanted. Which element is first is exact, of the hits that the rung finds.
  bool first_met = false;
  // The scene's box (catalogue::box): coordinates lie in [-box, box], lengths in [0, 2 box]; 0: there is none. No
  // answer depends on it. Where a set leaves it, the first rung of `certified` bounds each pair by itself.
  float box = 0;
  // The item of each element, one number for each; empty: each element is its own item. Answers are then about items: a
  // pair of items counts once, and flags and counts have as many numbers as items(). Items need not be dense, but flags
  // and counts of sparse ones take much memory.
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  std::function<void(double fraction)> progress = {}; // on the calling thread, about ten times a second
  std::stop_token stop = {};                          // a request ends the call soon, by `cancelled`
};

// Memory grows with what is asked for, with the pairs where there are owners, and by what the sets store
// (core/sets/stored_rows.hpp); never with the product of the sets. Throws usage_error (kinds, rung, box or owners
// that do not fit), std::bad_alloc or `cancelled`.
result collide(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
               const collide_options &options = {});

// Throws usage_error unless what is met first may be asked for, if it is or must be. It serves all engines.
void require_first_met(const predicate_info &predicate, answer_kind want, bool asked,
                       std::span<const std::uint32_t> owner_a);

} // namespace meetc

#endif
