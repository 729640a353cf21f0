// A number that counts its own roundings, by the rules of the proof written down once more. Emitted code that
// runs on it tells theta (of values) and phi (of magnitudes) without a look at the compiler's analysis.
// Include before any generated header, as tiny.hpp.
#ifndef MEETC_TESTS_BOUNDS_COUNTING_HPP
#define MEETC_TESTS_BOUNDS_COUNTING_HPP

#include <meetc/double_double.hpp>

#include <algorithm>

namespace meetc::bounds_test {

struct counted {
  // Of the arithmetic at hand.
  inline static bool fuses = true, differences_round = true;

  int roundings = 0;
  int scale = 0;        // of a constant: +-2^k is k + 1
  bool stored = false;  // a stored number, as it is
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
  // Of a value whose sign is all that is wanted, rounded to nearest: the last rounding keeps it.
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
