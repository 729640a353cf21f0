// The steps of emitted readings that are no polynomials.
#ifndef MEETC_NUMBER_ROOT_HPP
#define MEETC_NUMBER_ROOT_HPP

#include <meetc/environment/environment.hpp>

#include <cmath>

MEETC_NAMESPACE(meetc) {

// 1/x, rounded once. 0 where x is 0, and then nothing exists.
template <class T> MEETC_HD inline T reciprocal(const T &x, bool &exists) {
  if (x == T(0)) {
    exists = false;
    return T(0);
  }
  return T(1) / x;
}

// The square root of x, rounded once. 0 where x is negative, and then nothing is real.
template <class T> MEETC_HD inline T root(const T &x, bool &is_real) {
  using std::sqrt;
  if (x < T(0)) {
    is_real = false;
    return T(0);
  }
  return sqrt(x);
}

} // MEETC_NAMESPACE(meetc)

#endif
