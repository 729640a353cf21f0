// core/ladder.hpp: the functions that decide, in the order in which a batch of pairs goes through them.
//
// A plain rung and exact are one function. `certified` is four: fp32, fp64, fp64x2 and exact, each for what
// the one before left unsure.
#ifndef MEETC_CORE_LADDER_HPP
#define MEETC_CORE_LADDER_HPP

#include "meetc/support.hpp"

namespace meetc {

struct element_set;

// What the rungs of `certified` did; nothing under the other rungs.
struct rung_report {
  std::uint64_t unsure[bounded_rungs] = {0, 0, 0}; // pairs of elements that fp32, fp64 and fp64x2 handed on
  bool left_box_a = false, left_box_b = false;     // a number of this set lies outside of the stated box
};

struct ladder {
  const predicate_info *predicate = nullptr;
  decide_function steps[bounded_rungs + 1] = {};
  int count = 0;  // of the steps; 0: the predicate was not generated for this rung
  float side = 0; // above 0: the first step takes the bounds of a box with this side
  rung_report start;

  ladder(const predicate_info &of, rung precision);

  // Takes the bounds of [-box, box] where both sets lie in it and the predicate has them. 0: no box.
  void enter_box(float box, const element_set &a, const element_set &b);

  void decide(int step, const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) const {
    if (step == 0 && side > 0)
      predicate->certify_in_box(side, false, a, b, pairs, n, out);
    else
      steps[step](a, b, pairs, n, out);
  }
};

} // namespace meetc

#endif
