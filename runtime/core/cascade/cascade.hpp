// core/cascade/cascade.hpp: the filter cascade: the functions that decide, in the order in which a batch of pairs goes through
// them.
//
// A plain rung, exact and tolerant are one function each. `certified` is four: fp32, fp64, fp64x2 and exact, each for what
// the one before left unsure.
#ifndef MEETC_CORE_CASCADE_CASCADE_HPP
#define MEETC_CORE_CASCADE_CASCADE_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/views/status.hpp"

#include "meetc/support.hpp"

#include <functional>
#include <span>

namespace meetc {

struct element_set;

struct cascade {
  const predicate_info *predicate = nullptr;
  bool tolerant = false; // the rung tolerant decides
  decide_function rungs[bounded_rungs + 1] = {};
  int count = 0;  // number of rungs; 0: the predicate was not generated for this precision
  float side = 0; // above 0: the first rung uses the bounds of a box with this side
  // The values that the sets store for the first rung.
  stored_values stored_a, stored_b;
  rung_report start;

  cascade(const predicate_info &of, rung precision);

  // Uses the bounds of [-box, box] where both sets lie in it and the predicate has such bounds. 0: there is no box.
  void enter_box(float box, const element_set &a, const element_set &b);

  // Checks the assumptions of the rung tolerant about the sets: not_on_grid or left_box where they do not hold. The rungs
  // of `certified`, if there are any, decide sets that leave the box. Other rungs assume nothing.
  status check(const element_set &a, const element_set &b);

  // Decides n pairs by rung `at` alone, 0 <= at < count. The rows are packed, as in the predicate's kinds.
  void ask(int at, const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out) const {
    if (at == 0 && side > 0)
      predicate->certify_in_box(side, a, b, pairs, n, out);
    else
      rungs[at](a, b, pairs, n, out);
  }

  // Receives pairs that rung `at` has left unsure, before the next rung is asked.
  using unsure_pairs = std::function<void(int at, std::span<const index_pair> pairs)>;
  // Decides n pairs by one rung after the other, each for those that the one before left unsure. With `any`, no further rung
  // is asked once a pair is a hit, and the others may stay unsure.
  void decide(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
              bool any = false, const unsure_pairs &handed_on = {}) const;
};

} // namespace meetc

#endif
