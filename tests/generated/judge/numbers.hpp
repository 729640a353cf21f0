// Number types that record more than the result of an emitted program, and random numbers that are the same on every
// machine.
#ifndef MEETC_TESTS_GENERATED_NUMBERS_HPP
#define MEETC_TESTS_GENERATED_NUMBERS_HPP

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <gmpxx.h>
#include <random>

namespace meetc::generated_test {

// Exact rationals. GMP's own type has expression templates, which do not fit a template with one number type T.
struct exact {
  mpq_class v;

  exact() = default;
  explicit exact(int k) : v(k) {}
  explicit exact(double d) : v(d) {}
  explicit exact(mpq_class q) : v(std::move(q)) {}
  friend exact operator+(const exact &a, const exact &b) { return exact(mpq_class(a.v + b.v)); }
  friend exact operator-(const exact &a, const exact &b) { return exact(mpq_class(a.v - b.v)); }
  friend exact operator*(const exact &a, const exact &b) { return exact(mpq_class(a.v * b.v)); }
  friend exact operator/(const exact &a, const exact &b) { return exact(mpq_class(a.v / b.v)); }
  friend exact operator-(const exact &a) { return exact(mpq_class(-a.v)); }
  friend bool operator<(const exact &a, const exact &b) { return a.v < b.v; }
  friend bool operator>(const exact &a, const exact &b) { return a.v > b.v; }
};

// The rounding error that a program can make, counted operation by operation as in docs/numerics.md: |computed - exact|
// <= ((1 + u)^theta - 1) M, where M is the program on absolute values with every difference replaced by a sum. This
// holds for every order of evaluation, with or without fma, unless numbers underflow or overflow, since each operation
// multiplies its exact result by one factor 1 + delta, |delta| <= u.
struct error_count {
  mpq_class magnitude;
  int theta = 0;

  error_count() = default;
  explicit error_count(int k) : magnitude(std::abs(k)) {}
  explicit error_count(double d) : magnitude(abs(mpq_class(d))) {}
  error_count(mpq_class m, int t) : magnitude(std::move(m)), theta(t) {}
  friend error_count operator+(const error_count &a, const error_count &b) {
    return {a.magnitude + b.magnitude, 1 + std::max(a.theta, b.theta)};
  }
  friend error_count operator-(const error_count &a, const error_count &b) { return a + b; }
  friend error_count operator*(const error_count &a, const error_count &b) {
    return {a.magnitude * b.magnitude, 1 + a.theta + b.theta};
  }
  friend error_count operator/(const error_count &a, const error_count &b) {
    return {a.magnitude / b.magnitude, 1 + a.theta + b.theta};
  }
  friend error_count operator-(const error_count &a) { return a; }

  // (1 + u)^theta - 1 <= theta u / (1 - theta u), as long as theta u < 1.
  mpq_class bound(const mpq_class &u) const { return magnitude * (theta * u) / (1 - theta * u); }
};

// An integer that records the widest value of its type.
struct counted_integer {
  mpz_class v;
  inline static std::size_t widest = 0; // bits of its magnitude

  counted_integer() = default;
  explicit counted_integer(int k) : v(k) { note(); }
  explicit counted_integer(mpz_class z) : v(std::move(z)) { note(); }
  friend counted_integer operator+(const counted_integer &a, const counted_integer &b) {
    return counted_integer(mpz_class(a.v + b.v));
  }
  friend counted_integer operator-(const counted_integer &a, const counted_integer &b) {
    return counted_integer(mpz_class(a.v - b.v));
  }
  friend counted_integer operator*(const counted_integer &a, const counted_integer &b) {
    return counted_integer(mpz_class(a.v * b.v));
  }
  friend counted_integer operator-(const counted_integer &a) { return counted_integer(mpz_class(-a.v)); }
  friend bool operator<(const counted_integer &a, const counted_integer &b) { return a.v < b.v; }
  friend bool operator>(const counted_integer &a, const counted_integer &b) { return a.v > b.v; }

private:
  void note() {
    if (v != 0)
      widest = std::max(widest, mpz_sizeinbase(v.get_mpz_t(), 2));
  }
};

class random_numbers {
public:
  explicit random_numbers(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  // An integer in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return integer(1, n) == 1; }
  // A fraction of magnitude at most `limit` with a small denominator.
  mpq_class fraction(int limit = 9) {
    const int d = integer(1, 5);
    mpq_class q(integer(-limit * d, limit * d), d);
    q.canonicalize();
    return q;
  }
  // A multiple of 2^-23 in (-1, 1) with a random mantissa.
  float unit() { return static_cast<float>(integer(-0x7fffff, 0x7fffff)) * 0x1p-23F; }
  // Any finite float32, with all bit patterns equally likely.
  float pattern() {
    for (;;) {
      const auto b = static_cast<std::uint32_t>(engine_());
      if ((b >> 23 & 0xff) == 0xff)
        continue;
      float f;
      std::memcpy(&f, &b, sizeof f);
      return f;
    }
  }

private:
  std::mt19937_64 engine_;
};

} // namespace meetc::generated_test

#endif
