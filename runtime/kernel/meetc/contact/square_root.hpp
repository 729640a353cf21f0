// Square roots in float64 and in double-double.
#ifndef MEETC_CONTACT_SQUARE_ROOT_HPP
#define MEETC_CONTACT_SQUARE_ROOT_HPP

#include <meetc/number/double_double.hpp>

#include <cmath>

MEETC_NAMESPACE(meetc) {

MEETC_HD inline double square_root(double x) {
  return std::sqrt(x);
}
// Within 2^-103 of the root, by one step of Newton's method; 0 for a number that is not above 0.
template <bool F> MEETC_HD MEETC_INLINE double_words<F> square_root(const double_words<F> &x) {
  if (!(x.hi > 0))
    return double_words<F>(0.0);
  const double first = std::sqrt(x.hi);
  const double_words<F> rest = x - two_product<F>(first, first);
  return fast_two_sum<F>(first, rest.hi / (2 * first));
}

} // MEETC_NAMESPACE(meetc)

#endif
