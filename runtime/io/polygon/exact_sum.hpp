// A sum of doubles without rounding, as an expansion: doubles that do not overlap, in order of magnitude.
//
// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete & Computational
// Geometry 18, 1997: grow-expansion with zero elimination. Exact as long as nothing overflows or underflows, which sums of
// products of up to three float32 numbers do not. Needs the standard control word.
#ifndef MEETC_IO_POLYGON_EXACT_SUM_HPP
#define MEETC_IO_POLYGON_EXACT_SUM_HPP

#include <meetc/number/double_double.hpp>

#include <cstddef>
#include <vector>

namespace meetc::io {

class exact_sum {
public:
  void add(double x) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const auto s = two_sum(x, part);
      if (s.lo != 0)
        parts_[kept++] = s.lo;
      x = s.hi;
    }
    parts_.resize(kept);
    if (x != 0)
      parts_.push_back(x);
  }
  void add_product(double x, double y) {
    const auto p = two_product<false>(x, y);
    add(p.lo);
    add(p.hi);
  }
  // Adds the magnitude of another sum, or its negative.
  void add_magnitude(const exact_sum &other, bool negative) {
    const bool turn = (other.sign() < 0) != negative;
    for (const double part : std::vector<double>(other.parts_))
      add(turn ? -part : part);
  }
  void clear() { parts_.clear(); }
  int sign() const { return parts_.empty() ? 0 : parts_.back() > 0 ? 1 : -1; }
  // The value, rounded.
  double value() const {
    double sum = 0;
    for (const double part : parts_)
      sum += part;
    return sum;
  }

private:
  std::vector<double> parts_;
};

} // namespace meetc::io

#endif
