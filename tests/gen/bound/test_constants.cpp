// The emitted factors, compared with the formula, which is counted and computed here a second time in exact rationals.
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"

using namespace meetc::bounds_test;

namespace {

// `emitted` is at least q, and the next smaller number of 12 bits is below q.
bool is_rounded_up(double emitted, const mpq_class &q) {
  const mpq_class e(emitted);
  if (q == 0)
    return e == 0;
  int exponent;
  std::frexp(emitted, &exponent);
  return e >= q && e - power_of_two(exponent - 12) < q;
}

struct counts {
  std::vector<counted> values, magnitudes;
  counts(const stage_case &c, bool fuses, bool differences_round)
      : values(static_cast<std::size_t>(c.signs)), magnitudes(static_cast<std::size_t>(c.signs)) {
    counted::fuses = fuses;
    counted::differences_round = differences_round;
    c.count(values.data(), magnitudes.data());
  }
};

} // namespace

TEST_CASE("constants: theta and phi are what the emitted code itself counts") {
  for (const stage_case &c : both_schedules()) {
    INFO(c.name);
    const counts plain(c, true, true), wide(c, false, false);
    // Magnitudes are always computed in fp32 or fp64.
    const counts of_magnitudes(c, true, true);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.signs); ++i) {
      INFO("sign " << i);
      CHECK(c.bounds->fp32[i].theta == plain.values[i].without_last());
      CHECK(c.bounds->fp64[i].theta == plain.values[i].without_last());
      CHECK(c.bounds->fp64x2[i].theta == wide.values[i].roundings); // not monotonic: every rounding counts
      CHECK(c.bounds->fp32[i].phi == of_magnitudes.magnitudes[i].roundings);
      CHECK(c.bounds->fp64[i].phi == of_magnitudes.magnitudes[i].roundings);
      CHECK(c.bounds->fp64x2[i].phi == of_magnitudes.magnitudes[i].roundings);
      CHECK(c.bounds->fp32[i].degree == c.degree_of(static_cast<int>(i)));
    }
  }
}

TEST_CASE("constants: emitted factors are the formula's, rounded up and no further") {
  int signs = 0;
  for (const stage_case &c : both_schedules()) {
    INFO(c.name);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.signs); ++i, ++signs) {
      INFO("sign " << i);
      const meetc::factors k = c.factor(static_cast<int>(i));
      const auto &r32 = c.bounds->fp32[i], &r64 = c.bounds->fp64[i], &r128 = c.bounds->fp64x2[i];
      const mpq_class u32 = power_of_two(-24), u64 = power_of_two(-53), u128 = power_of_two(-102);
      CHECK(is_rounded_up(static_cast<double>(k.fp32), threshold_factor(r32.theta, r32.phi, u32, u32)));
      CHECK(is_rounded_up(k.fp64, threshold_factor(r64.theta, r64.phi, u64, u64)));
      // M has differences rounded to fp64; the high word represents the value.
      const mpq_class rounded_leaves = power(1 + u64, r128.degree + 8);
      CHECK(is_rounded_up(k.fp64x2, threshold_factor(r128.theta, r128.phi, u128, u64) * rounded_leaves));
    }
  }
  CHECK(signs > 400);
}

TEST_CASE("constants: floors keep every threshold a normal number, boxes keep every value finite") {
  for (const stage_case &c : both_schedules()) {
    INFO(c.name);
    const int least_fp64 = std::max(c.floor_fp64, -149);
    for (int i = 0; i < c.signs; ++i) {
      INFO("sign " << i);
      const meetc::factors k = c.factor(i);
      const int degree = c.degree_of(i);
      // The least magnitude, all leaves at the floor; no difference of float32 numbers is below 2^-149.
      if (k.fp32 > 0)
        CHECK(mpq_class(static_cast<double>(k.fp32)) * power_of_two(c.floor_fp32 * degree) >= power_of_two(-126));
      if (k.fp64x2 > 0)
        CHECK(mpq_class(k.fp64x2) * power_of_two(least_fp64 * degree) >= power_of_two(-1022));
      const meetc::box_factor f = c.box(i);
      CHECK(f.a + f.b + f.pair == degree);
      if (f.c > 0)
        CHECK(mpq_class(static_cast<double>(f.c)) * power_of_two(c.box_lowest * degree) >= power_of_two(-126));
      CHECK(c.box_highest * degree + c.growth < 127);
    }
    // Low words of double-double products stay normal.
    CHECK(least_fp64 * c.degree - 106 >= -1074);
  }
}
