// The rungs after fp32, for rows. Few pairs need them. On a host the generated library compiles them and the entry
// points call them there; see entry.hpp.
#ifndef MEETC_DECIDE_LATER_RUNGS_HPP
#define MEETC_DECIDE_LATER_RUNGS_HPP

#include <meetc/decide/decide.hpp>

MEETC_NAMESPACE(meetc) {

// The answer for a pair that fp32 leaves unsure, in any environment.
template <class P> MEETC_HD inline bool later_rungs(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide<P>(integer_signs<P>(row_a, row_b));
  return before_return(decide_after_fp32<P>(after_check(row_a), after_check(row_b)));
}
template <class P> MEETC_HD inline bool decide_exactly(const float *row_a, const float *row_b) {
  return before_return(decide_exact<P>(row_a, row_b));
}

// The same for one sign.
template <class P> MEETC_HD inline sign later_rungs_sign(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide_sign<P>(integer_signs<P>(row_a, row_b));
  return before_return(decide_sign<P>(exact_signs<P>(after_check(row_a), after_check(row_b))));
}
template <class P> MEETC_HD inline sign decide_exactly_sign(const float *row_a, const float *row_b) {
  return before_return(decide_sign<P>(exact_signs<P>(row_a, row_b)));
}

} // MEETC_NAMESPACE(meetc)

#endif
