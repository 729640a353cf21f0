// Arithmetic of 200 bits: the truth for numbers with roots and angles. A number type of emitted code.
#ifndef MEETC_TESTS_GENERATED_WIDE_HPP
#define MEETC_TESTS_GENERATED_WIDE_HPP

#include <mpfr.h>
#include <utility>

namespace meetc::generated_test {

class wide {
public:
  wide(double x = 0) : wide(nothing{}) { mpfr_set_d(v_, x, MPFR_RNDN); }
  wide(const wide &x) : wide(nothing{}) { mpfr_set(v_, x.v_, MPFR_RNDN); }
  wide &operator=(const wide &x) {
    mpfr_set(v_, x.v_, MPFR_RNDN);
    return *this;
  }
  ~wide() { mpfr_clear(v_); }

  explicit operator double() const { return mpfr_get_d(v_, MPFR_RNDN); }
  explicit operator float() const { return mpfr_get_flt(v_, MPFR_RNDN); }

  friend wide operator+(const wide &a, const wide &b) { return made(mpfr_add, a, b); }
  friend wide operator-(const wide &a, const wide &b) { return made(mpfr_sub, a, b); }
  friend wide operator*(const wide &a, const wide &b) { return made(mpfr_mul, a, b); }
  friend wide operator/(const wide &a, const wide &b) { return made(mpfr_div, a, b); }
  friend wide atan2(const wide &a, const wide &b) { return made(mpfr_atan2, a, b); }
  friend wide operator-(const wide &a) { return wide(0) - a; }
  friend bool operator<(const wide &a, const wide &b) { return mpfr_less_p(a.v_, b.v_) != 0; }
  friend bool operator>(const wide &a, const wide &b) { return b < a; }
  friend bool operator==(const wide &a, const wide &b) { return mpfr_equal_p(a.v_, b.v_) != 0; }
  friend wide sqrt(const wide &a) { return made(mpfr_sqrt, a); }
  friend wide sin(const wide &a) { return made(mpfr_sin, a); }
  friend wide cos(const wide &a) { return made(mpfr_cos, a); }
  friend wide abs(const wide &a) { return a < wide(0) ? -a : a; }
  // The range of exponents is so wide that no scale is needed.
  friend int ilogb(const wide &) { return 0; }
  friend wide scalbn(const wide &a, int) { return a; }

private:
  mpfr_t v_;

  struct nothing {};
  explicit wide(nothing) { mpfr_init2(v_, 200); }
  template <class F, class... Rest> static wide made(F f, const Rest &...of) {
    wide out;
    f(out.v_, of.v_..., MPFR_RNDN);
    return out;
  }
};

} // namespace meetc::generated_test

#endif
