// Compares a stage's values in tiny precision with the bound in the magnitude form.
#ifndef MEETC_TESTS_BOUNDS_JUDGE_HPP
#define MEETC_TESTS_BOUNDS_JUDGE_HPP

#include "tests/gen/bound/stages.hpp"

#include <gmpxx.h>

namespace meetc::bounds_test {

mpz_class to_mpz(int128 v);
mpq_class power_of_two(int e);
mpq_class power(const mpq_class &base, int exponent);

// The bound, written down a second time: (1 + u)^theta - 1 and the K of its computed form, with u = 2^-precision.
mpq_class rounding_growth(int theta, const mpq_class &u);
mpq_class threshold_factor(int theta, int phi, const mpq_class &u, const mpq_class &u_of_magnitude);

// The results of one run of a stage in tiny precision, by sign. Values are in units of 2^(scale degree).
class run_of_stage {
public:
  // floor: the least magnitude of a leaf that is not zero; 0: none.
  run_of_stage(const stage_case &c, const sample &s, double floor);

  int128 exact(int i) const { return exact_[at(i)]; }
  int128 magnitude(int i) const { return magnitude_[at(i)]; } // M, of leaves as computed
  const tiny &value(int i) const { return value_[at(i)]; }
  const tiny &computed_magnitude(int i) const { return computed_magnitude_[at(i)]; }
  // v^ - v| before the last rounding, on which no sign depends.
  int128 error(int i) const;

private:
  const stage_case &case_;
  int scale_;
  std::vector<int128> exact_, magnitude_;
  std::vector<tiny> value_, computed_magnitude_;
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int128 in_units(double v, int i) const;
};

} // namespace meetc::bounds_test

#endif
