// A number of a few bits, rounded to nearest even after every operation, on which emitted code runs
// unchanged.
//
// Method: the value is kept in a double. A sum of two doubles is known exactly as a rounded sum and a remainder, and a
// product of numbers of at most 24 bits is exact, so each result is rounded once from its exact value. The format
// (precision, least exponent) is global, so that one instantiation of the emitted code serves all formats.
//
// Limits: exponents well inside double's; no overflow is simulated. Include this before any generated header:
// those call ::meetc::fma with a qualified name, which finds only what is declared before them.
#ifndef MEETC_TESTS_BOUNDS_TINY_HPP
#define MEETC_TESTS_BOUNDS_TINY_HPP

#include <meetc/number/double_double.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace meetc::bounds_test {

struct tiny_format {
  int precision = 8;
  int lowest = -900; // values are multiples of 2^lowest: gradual underflow
  // Whether a sum takes a product unrounded, as with a compiler that contracts the two to a fused multiply-add: in the
  // programs of values, and in those of magnitudes.
  bool contract_values = false, contract_magnitudes = false;
};

// A sum of two doubles, exactly.
struct exact_sum {
  double high, low;
};
inline exact_sum sum_of(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

class tiny {
public:
  inline static tiny_format format;
  inline static bool contracting = false; // the program that runs now
  inline static bool fusing = true;       // whether fma() rounds once

  tiny() = default;
  explicit tiny(int k) : tiny(rounded({static_cast<double>(k), 0})) {}
  // The number d, which the format must be able to represent.
  static tiny of(double d) { return tiny(d, {d, 0}); }
  static tiny rounded(const exact_sum &x) { return tiny(nearest(x), x); }

  double value() const { return value_; }
  exact_sum unrounded() const { return unrounded_; } // the exact result of the last operation

  // One of two products stays unrounded, since an fma() has only one.
  friend tiny operator+(tiny a, tiny b) {
    if (contracting && a.product_)
      return rounded(sum_of(a.unrounded_.high, b.value_));
    return rounded(sum_of(a.value_, contracting && b.product_ ? b.unrounded_.high : b.value_));
  }
  friend tiny operator-(tiny a, tiny b) { return a + -b; }
  friend tiny operator*(tiny a, tiny b) {
    tiny r = rounded({a.value_ * b.value_, 0});
    r.product_ = true;
    return r;
  }
  friend tiny operator-(tiny a) {
    tiny r(-a.value_, {-a.unrounded_.high, -a.unrounded_.low});
    r.product_ = a.product_;
    return r;
  }
  friend bool operator<(tiny a, tiny b) { return a.value_ < b.value_; }
  friend bool operator>(tiny a, tiny b) { return a.value_ > b.value_; }
  friend bool operator==(tiny a, tiny b) { return a.value_ == b.value_; }
  friend tiny magnitude_of(tiny a) { return tiny(std::abs(a.value_), {std::abs(a.value_), 0}); }
  friend tiny leading(tiny a) { return a; }

private:
  double value_;
  exact_sum unrounded_;
  bool product_ = false; // of two numbers, perhaps negated
  tiny(double v, exact_sum u) : value_(v), unrounded_(u) {}

  static double nearest(const exact_sum &x) {
    if (x.high == 0)
      return 0;
    std::uint64_t word;
    std::memcpy(&word, &x.high, sizeof word);
    const int exponent = static_cast<int>(word >> 52 & 0x7ff) - 1023;
    const int last = std::max(exponent + 1 - format.precision, format.lowest);
    const auto power = static_cast<std::uint64_t>(last + 1023) << 52;
    double unit;
    std::memcpy(&unit, &power, sizeof unit);
    const double shift = 0x1.8p52 * unit; // the sum has the last place wanted, and is rounded to nearest even
    const double r = (x.high + shift) - shift;
    if (x.low != 0 && std::abs(x.high - r) == unit / 2) // no tie after all
      return x.high + std::copysign(unit / 2, x.low);
    return r;
  }
};

} // namespace meetc::bounds_test

namespace meetc {
inline meetc::bounds_test::tiny fma(meetc::bounds_test::tiny a, meetc::bounds_test::tiny b,
                                    meetc::bounds_test::tiny c) {
  using meetc::bounds_test::tiny;
  return tiny::fusing ? tiny::rounded(meetc::bounds_test::sum_of(a.value() * b.value(), c.value())) : a * b + c;
}
} // namespace meetc

#endif
