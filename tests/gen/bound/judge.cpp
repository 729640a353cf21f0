#include "tests/gen/bound/judge.hpp"

namespace meetc::bounds_test {

mpz_class to_mpz(int128 v) {
  const bool negative = v < 0;
  const auto m = static_cast<meetc::uint128>(negative ? -v : v);
  mpz_class z(static_cast<unsigned long>(m >> 64));
  z <<= 64;
  z += static_cast<unsigned long>(m);
  return negative ? mpz_class(-z) : z;
}

mpq_class power_of_two(int e) {
  mpz_class z = 1;
  z <<= static_cast<mp_bitcnt_t>(std::abs(e));
  return e >= 0 ? mpq_class(z) : mpq_class(mpz_class(1), z);
}

mpq_class power(const mpq_class &base, int exponent) {
  mpq_class out = 1;
  for (int i = 0; i < exponent; ++i)
    out *= base;
  return out;
}

mpq_class rounding_growth(int theta, const mpq_class &u) {
  return power(1 + u, theta) - 1;
}

mpq_class threshold_factor(int theta, int phi, const mpq_class &u, const mpq_class &u_of_magnitude) {
  return rounding_growth(theta, u) / power(1 - u_of_magnitude, phi + 1);
}

run_of_stage::run_of_stage(const stage_case &c, const sample &s, double floor)
    : case_(c), scale_(s.scale), exact_(at(c.signs)), magnitude_(at(c.signs)), value_(at(c.signs)),
      computed_magnitude_(at(c.signs)) {
  c.in_tiny(s, floor, value_.data(), computed_magnitude_.data());
  c.in_integers(s, floor, exact_.data(), magnitude_.data());
}

int128 run_of_stage::in_units(double v, int i) const {
  return static_cast<int128>(std::ldexp(v, -scale_ * case_.degree_of(i)));
}

int128 run_of_stage::error(int i) const {
  const exact_sum w = value(i).unrounded();
  const int128 d = in_units(w.high, i) + in_units(w.low, i) - exact(i);
  return d < 0 ? -d : d;
}

} // namespace meetc::bounds_test
