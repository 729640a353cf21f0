// Where a segment meets a ball, in rational numbers: no root is computed. With f(t) the power of p + t d, a root lies before or
// after t by the sign of f(t) and by the side of t on which f is least.
#pragma once
#include <array>
#include <cmath>
#include <cstring>
#include <gmpxx.h>
#include <limits>
#include <type_traits>
#include <vector>

namespace meetc::contacts_test {

// Rows: centre and radius; two ends.
class round_truth {
public:
  round_truth(const float *ball, const float *segment);

  // The labels by their definition, in the order of the segment, as carriers of both.
  struct label {
    int ball, segment;
  };
  std::vector<label> labels(bool surface) const;

  // The signs of coordinate k of the root minus x, and of the root's t minus another one.
  int side(int which, int k, const mpq_class &x) const;
  int root_side(int which, const mpq_class &t) const;

private:
  std::array<mpq_class, 3> p_, d_;
  mpq_class a_, b_, c_, least_at_; // f(t) = a - 2 b t + c t^2

  mpq_class power(const mpq_class &t) const { return a_ + t * (c_ * t - 2 * b_); }
};

template <class Real> bool is_even(Real x) {
  std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t> bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits & 1) == 0;
}
template <class Real> Real next(Real x, int direction) {
  return std::nextafter(x, static_cast<Real>(direction) * std::numeric_limits<Real>::infinity());
}
template <class Real> mpq_class halfway(Real x, int direction) {
  const Real y = next(x, direction);
  if (!std::isfinite(y))
    return mpq_class(x) + (mpq_class(x) - mpq_class(next(x, -direction))) / 2;
  return (mpq_class(x) + mpq_class(y)) / 2;
}
// Whether f is the number nearest to x, and of two the even one; side(y) is the sign of x - y.
template <class Real, class Side> bool is_rounded(Real f, const Side &side) {
  if (!std::isfinite(f) || (f == 0 && std::signbit(f)))
    return false;
  const int above = side(halfway(f, -1)), below = side(halfway(f, 1));
  return (above > 0 || (above == 0 && is_even(f))) && (below < 0 || (below == 0 && is_even(f)));
}

} // namespace meetc::contacts_test
