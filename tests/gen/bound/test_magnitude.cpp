// The magnitude form in precisions of 4 to 11 bits: no input that was found beats it, and some inputs beat anything
// smaller.
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"
#include "tests/gen/bound/search.hpp"
#include "tests/generated/judge/effort.hpp"

#include <limits>

using namespace meetc::bounds_test;
using meetc::generated_test::effort;

namespace {

constexpr int precisions[] = {4, 5, 6, 8, 11};

number_range range_of(const stage_case &c, int precision) {
  return {precision, std::min(c.bits(), precision + 20)};
}

// error > growth M, exactly. Doubles are tried first, since it is hardly ever close.
bool beats(int128 error, const mpq_class &growth, double growth_double, int128 m) {
  if (static_cast<double>(error) < growth_double * static_cast<double>(m) * (1 - 1e-9))
    return false;
  return mpq_class(to_mpz(error)) > growth * mpq_class(to_mpz(m));
}

// The claims of the proof about sign i at one precision.
struct claims {
  int theta, phi;
  mpq_class u, growth, factor;
  double growth_double, factor_double;
  tiny factor_rounded; // up, to the precision

  claims(const stage_case &c, int i, int precision)
      : theta(c.bounds->fp32[static_cast<std::size_t>(i)].theta), phi(c.bounds->fp32[static_cast<std::size_t>(i)].phi),
        u(power_of_two(-precision)), growth(rounding_growth(theta, u)), factor(threshold_factor(theta, phi, u, u)),
        growth_double(growth.get_d()), factor_double(factor.get_d()),
        factor_rounded(tiny::of(meetc::bound::rounded_up(factor, precision).get_d())) {}

  bool value_is_near(const run_of_stage &r, int i) const {
    return !beats(r.error(i), growth, growth_double, r.magnitude(i));
  }
  // M^ >= M (1 - u)^phi
  bool magnitude_is_large(const run_of_stage &r, int i) const {
    return mpq_class(r.computed_magnitude(i).value()) >= mpq_class(to_mpz(r.magnitude(i))) * power(1 - u, phi);
  }
  // The rung's own rule: v^ > fl(K M^) should prove v > 0. The K used is `times` the true one.
  bool sign_is_right(const run_of_stage &r, int i, double times = 1) const {
    const tiny m = r.computed_magnitude(i), v = r.value(i);
    if (m.value() == 0)
      return r.exact(i) == 0 && v.value() == 0;
    const tiny k = times == 1 ? factor_rounded : tiny::rounded({factor_double * times, 0});
    const tiny threshold = k * m;
    return v > threshold ? r.exact(i) > 0 : v < -threshold ? r.exact(i) < 0 : true;
  }
};

// |v^ - v| / (growth M); 0 where there is nothing to bound.
double ratio(const run_of_stage &r, int i, double growth) {
  const auto e = static_cast<double>(r.error(i)), m = static_cast<double>(r.magnitude(i));
  return e == 0 ? 0 : growth == 0 || m == 0 ? 1e9 : e / (growth * m);
}

// How far beyond 0 a value is computed, as a share of K M^, less the true value on that side. It is above 0 only where
// the error exceeds the value.
double wrong_side(const run_of_stage &r, int i, double factor, double weight) {
  const double v = r.value(i).value(), m = r.computed_magnitude(i).value();
  if (m == 0)
    return 0;
  const auto exact = static_cast<double>(r.exact(i));
  return (std::abs(v) - weight * std::max(0.0, v < 0 ? -exact : exact)) / (factor * m);
}

} // namespace

TEST_CASE("magnitude form: no sign's bound is beaten on thousands of hostile inputs") {
  for (const int precision : precisions) {
    tiny::format = {precision, -900};
    for (const stage_case &c : both_schedules()) {
      INFO(c.name << ", " << precision << " bits");
      std::vector<claims> of_sign;
      for (int i = 0; i < c.signs; ++i)
        of_sign.emplace_back(c, i, precision);
      random_numbers random(static_cast<std::uint64_t>(precision));
      bool near = true, large = true, right = true;
      for (int n = 0; n < effort(2000); ++n) {
        const run_of_stage r(c, any_sample(c, range_of(c, precision), random), 0);
        for (int i = 0; i < c.signs; ++i) {
          const claims &s = of_sign[static_cast<std::size_t>(i)];
          near = near && s.value_is_near(r, i);
          right = right && s.sign_is_right(r, i);
          if (n % 16 == 0)
            large = large && s.magnitude_is_large(r, i);
        }
      }
      CHECK(near);
      CHECK(large);
      CHECK(right);
    }
  }
}

// A compiler may contract products and sums of one program and not of the other. Each loses roundings and gains none.
TEST_CASE("magnitude form: holds however compilers contract products and sums") {
  int values = 0, magnitudes = 0; // that contraction changed
  for (const int precision : precisions)
    for (const stage_case &c : both_schedules()) {
      INFO(c.name << ", " << precision << " bits");
      tiny::format = {precision, -900};
      std::vector<claims> of_sign;
      for (int i = 0; i < c.signs; ++i)
        of_sign.emplace_back(c, i, precision);
      random_numbers random(static_cast<std::uint64_t>(precision) + 50);
      bool near = true, large = true, right = true;
      for (int n = 0; n < effort(300); ++n) {
        const sample x = any_sample(c, range_of(c, precision), random);
        tiny::format = {precision, -900};
        const run_of_stage written(c, x, 0);
        for (const auto &[of_values, of_magnitudes] : {std::pair(true, false), {false, true}, {true, true}}) {
          tiny::format = {precision, -900, of_values, of_magnitudes};
          const run_of_stage r(c, x, 0);
          for (int i = 0; i < c.signs; ++i) {
            const claims &s = of_sign[static_cast<std::size_t>(i)];
            near = near && s.value_is_near(r, i);
            right = right && s.sign_is_right(r, i);
            if (n % 16 == 0)
              large = large && s.magnitude_is_large(r, i);
            values += r.value(i).value() != written.value(i).value();
            magnitudes += r.computed_magnitude(i).value() != written.computed_magnitude(i).value();
          }
        }
      }
      CHECK(near);
      CHECK(large);
      CHECK(right);
    }
  tiny::format = {};
  CHECK(values > 0);
  CHECK(magnitudes > 0);
}

// If the two programs are contracted differently, one can overflow without the other.
TEST_CASE("magnitude form: a value that is not finite proves nothing, whatever its magnitude") {
  constexpr float inf = std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::max();
  for (const float error : {0.0F, 1.0F, most, inf, std::numeric_limits<float>::quiet_NaN()})
    for (const float v : {inf, -inf, std::numeric_limits<float>::quiet_NaN()})
      CHECK(meetc::within(v, error).bits == 7);
  CHECK(meetc::within(most, 0x1.fffffcp127F).bits == 4);
  CHECK(meetc::within(-most, 0x1.fffffcp127F).bits == 1);
  CHECK(meetc::within(most, most).bits == 7);
}

TEST_CASE("magnitude form: climbing does not beat it, and shows that a quarter of it would not do") {
  for (const stage_case &c : both_schedules())
    for (int i = 0; i < c.signs; ++i) {
      INFO(c.name << ", sign " << i);
      const bool computed = c.bounds->fp32[static_cast<std::size_t>(i)].theta > 0;
      double most = 0;
      for (const int precision : {5, 8, 11}) {
        tiny::format = {precision, -900};
        const claims s(c, i, precision);
        random_numbers random(static_cast<std::uint64_t>(100 * precision + i));
        bool held = true;
        const double best = climb(c, range_of(c, precision), random, 3, steps_of_climb(800), [&](const sample &x) {
          const run_of_stage r(c, x, 0);
          held = held && s.value_is_near(r, i) && s.sign_is_right(r, i);
          return ratio(r, i, s.growth_double);
        });
        CHECK(held);
        most = std::max(most, best);
      }
      // A sign that is a difference or a stored number has no error and no bound to beat.
      if (computed)
        CHECK(most > 0.25);
      else
        CHECK(most == 0);
    }
}

// theta - 1 instead of theta. The two come close only where few roundings meet, so it must show there.
TEST_CASE("magnitude form: mutation: one rounding less is beaten on signs of few roundings") {
  int beaten = 0, tried = 0;
  tiny::format = {11, -900};
  for (const stage_case &c : both_schedules())
    for (int i = 0; i < c.signs; ++i) {
      const int theta = c.bounds->fp32[static_cast<std::size_t>(i)].theta;
      if (theta == 0 || theta > 4)
        continue;
      ++tried;
      const double less = rounding_growth(theta - 1, power_of_two(-11)).get_d();
      random_numbers random(static_cast<std::uint64_t>(i));
      const auto share = [&](const sample &x) { return ratio(run_of_stage(c, x, 0), i, less); };
      const double best = climb(c, range_of(c, 11), random, 4, 2000, share, 1);
      beaten += best > 1;
    }
  INFO(beaten << " of " << tried);
  CHECK(tried > 100);
  CHECK(beaten > tried / 2);
}

// The rung would not only exceed the bound: it would certify a wrong sign.
TEST_CASE("magnitude form: mutation: a quarter of K certifies wrong signs") {
  for (const stage_case &c : both_schedules())
    for (int i = 0; i < c.signs; ++i) {
      if (c.bounds->fp32[static_cast<std::size_t>(i)].theta == 0)
        continue;
      INFO(c.name << ", sign " << i);
      bool wrong = false;
      for (std::uint64_t seed = 0; seed < 60 && !wrong; ++seed) {
        const int precision = seed % 2 ? 11 : 8;
        tiny::format = {precision, -900};
        const claims s(c, i, precision);
        random_numbers random(seed);
        constexpr double enough = 1e9;
        const auto score = [&](const sample &x) {
          const run_of_stage r(c, x, 0);
          wrong = wrong || !s.sign_is_right(r, i, 0.25);
          return wrong ? 2 * enough : wrong_side(r, i, s.factor_double, seed % 3 == 0 ? 1.02 : 1.3);
        };
        climb(c, range_of(c, precision), random, 4, 1500, score, enough);
      }
      CHECK(wrong);
    }
}
