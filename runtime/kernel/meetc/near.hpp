// The tests that a pair from a filter must pass before it is decided: its boxes touch, and the reject stage does not
// rule it out. Kernels call them, and so does their stand-in on a host.
#ifndef MEETC_NEAR_HPP
#define MEETC_NEAR_HPP

#include <meetc/decide.hpp>
#include <meetc/stored.hpp>

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

// Whether the reject stage, certified in fp32, rules the pair out. P must have one.
template <class P> MEETC_HD inline bool surely_rejected(const stored_pair &p) {
  sign_set s[P::atoms + 1];
  stored_bounded_signs<P>{p}.template get<typename P::reject_stage>(s);
  return !can_be_false(P::rejected(s));
}

} // MEETC_NAMESPACE(meetc)

#endif
