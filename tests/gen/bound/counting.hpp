// A number that counts its own roundings, by the rules of the proof written down a second time. Emitted code that runs
// on it gives theta (of values) and phi (of magnitudes) without the compiler's analysis. Like tiny.hpp, it must be
// included before any generated header.
#ifndef MEETC_TESTS_BOUNDS_COUNTING_HPP
#define MEETC_TESTS_BOUNDS_COUNTING_HPP

#include <meetc/number/double_double.hpp>

#include <algorithm>

namespace meetc::bounds_test {

struct counted {
  // Properties of the arithmetic that is simulated.
  inline static bool fuses = true, differences_round = true;

  int roundings = 0;
  int scale = 0;        // for constants: +-2^k is stored as k + 1
  bool stored = false;  // the value is a stored number itself
  bool rounded = false; // the last operation rounded

  counted() = default;
  explicit counted(int k) {
    const int m = k < 0 ? -k : k;
    if (m > 0 && (m & (m - 1)) == 0)
      scale = 1 + __builtin_ctz(static_cast<unsigned>(m));
  }
  static counted input() {
    counted c;
    c.stored = true;
    return c;
  }
  static counted of(int roundings) {
    counted c;
    c.roundings = roundings;
    c.rounded = true;
    return c;
  }
  // For a value of which only the sign is wanted. Rounding to nearest keeps the sign, so the last rounding does not
  // count.
  int without_last() const { return roundings - (rounded ? 1 : 0); }

  friend counted operator+(const counted &a, const counted &b) { return of(1 + std::max(a.roundings, b.roundings)); }
  friend counted operator-(const counted &a, const counted &b) {
    if (a.stored && b.stored) {
      counted c = of(differences_round ? 1 : 0);
      c.rounded = differences_round;
      return c;
    }
    return a + b;
  }
  friend counted operator*(const counted &a, const counted &b) {
    if (a.scale || b.scale) {
      counted c = a.scale ? b : a;
      c.stored = false;
      return c;
    }
    return of(1 + a.roundings + b.roundings);
  }
  friend counted operator-(const counted &a) { return a; }
};

} // namespace meetc::bounds_test

namespace meetc {
inline meetc::bounds_test::counted fma(const meetc::bounds_test::counted &a, const meetc::bounds_test::counted &b,
                                       const meetc::bounds_test::counted &c) {
  using meetc::bounds_test::counted;
  const int product = a.roundings + b.roundings + (counted::fuses || a.scale || b.scale ? 0 : 1);
  return counted::of(1 + std::max(product, c.roundings));
}
} // namespace meetc

#endif
