// The tests that a pair from a filter must pass before it is decided: its boxes touch, the reject stage does not rule it
// out, and its points do not settle it. Kernels call them, and so does their stand-in on a host.
#ifndef MEETC_NEAR_HPP
#define MEETC_NEAR_HPP

#include <meetc/decide.hpp>

MEETC_NAMESPACE(meetc) {

// Whether the closed boxes of a row of A and a row of B touch. Boxes that exceed float32 have infinite ends. Two boxes
// are apart only where a comparison holds, and none holds with NaN.
template <class A, class B> MEETC_HD inline bool boxes_touch(const float *a, const float *b) {
  float low_a[3], high_a[3], low_b[3], high_b[3];
  A::box(a, low_a, high_a);
  B::box(b, low_b, high_b);
  bool touch = true;
  for (int k = 0; k < 3; ++k)
    touch &= !(low_a[k] > high_b[k]) && !(low_b[k] > high_a[k]);
  return touch;
}

// The progress of the pair by the reject stage, certified in fp32, and by equal points. P must have such a stage.
template <class P> MEETC_HD inline progress try_to_reject(const float *row_a, const float *row_b) {
  found_signs<P> f;
  return try_to_reject<P>(bounded_signs<P, in_fp32>(row_a, row_b), f);
}

} // MEETC_NAMESPACE(meetc)

#endif
