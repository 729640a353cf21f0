// core/views/collinear.hpp: whether three points lie on one line.
#ifndef MEETC_CORE_VIEWS_COLLINEAR_HPP
#define MEETC_CORE_VIEWS_COLLINEAR_HPP

#include "meetc/support.hpp"

namespace meetc {

// row: the nine finite coordinates of three points. The answer is exact.
bool collinear(const float *row);

// False: they do not. In doubles a difference of floats and a product of two have relative errors of 2^-53 each, and nothing
// under- or overflows: a difference of products is off by at most 2^-50 times the sum of their magnitudes.
MEETC_HD inline bool may_be_collinear(const float *row) {
  double of_a[3], of_b[3];
  for (int k = 0; k < 3; ++k) {
    of_a[k] = static_cast<double>(row[3 + k]) - static_cast<double>(row[k]);
    of_b[k] = static_cast<double>(row[6 + k]) - static_cast<double>(row[k]);
  }
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    const double x = of_a[k] * of_b[l], y = of_a[l] * of_b[k];
    if (magnitude_of(x - y) > 0x1p-50 * (magnitude_of(x) + magnitude_of(y)))
      return false;
  }
  return true;
}

} // namespace meetc

#endif
