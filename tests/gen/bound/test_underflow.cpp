// Gradual underflow: with a least exponent, the magnitude form holds if leaves count as at least the floor, and not
// without that.
//
// The floor's rule at any precision p and least subnormal 2^lowest is floor^degree >= 2^(lowest + 2p - 1), so that even
// u M is a normal number. For float32 that is 2^-102.
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"
#include "tests/gen/bound/search.hpp"
#include "tests/generated/judge/effort.hpp"

using namespace meetc::bounds_test;
using meetc::generated_test::effort;

namespace {

struct underflow_range {
  tiny_format format;
  number_range numbers;
  double floor;
};

// The deepest least exponent for which numbers on both sides of the floor fit an int128.
underflow_range underflow_of(const stage_case &c, int precision) {
  for (int lowest = -60;; ++lowest) {
    const int floor = -((-lowest - 2 * precision + 1) / c.degree);
    if (floor - lowest + 2 <= c.bits())
      return {{precision, lowest}, {precision, floor - lowest + 2}, std::ldexp(1.0, floor)};
  }
}

struct outcome {
  double ratio = 0;         // |v^ - v| / (growth M)
  bool zero_is_zero = true; // M^ = 0 if and only if M = 0, and then v = 0
  bool sign_is_right = true;
};

outcome judge(const stage_case &c, const sample &s, int i, double floor) {
  const run_of_stage r(c, s, floor);
  const auto &counts = c.bounds->fp32[static_cast<std::size_t>(i)];
  const double u = std::ldexp(1.0, -tiny::format.precision);
  const double growth = std::expm1(counts.theta * std::log1p(u));
  outcome out;
  const tiny v = r.value(i), m = r.computed_magnitude(i);
  if (floor > 0) {
    out.zero_is_zero =
        (m.value() == 0) == (r.magnitude(i) == 0) && (m.value() != 0 || (r.exact(i) == 0 && v.value() == 0));
    const mpq_class factor = threshold_factor(counts.theta, counts.phi, power_of_two(-tiny::format.precision),
                                              power_of_two(-tiny::format.precision));
    const tiny threshold = tiny::of(meetc::bound::rounded_up(factor, tiny::format.precision).get_d()) * m;
    out.sign_is_right = v > threshold ? r.exact(i) > 0 : !(v < -threshold) || r.exact(i) < 0;
  }
  const auto error = static_cast<double>(r.error(i)), magnitude = static_cast<double>(r.magnitude(i));
  out.ratio = error == 0 ? 0 : growth == 0 || magnitude == 0 ? 1e9 : error / (growth * magnitude);
  return out;
}

} // namespace

TEST_CASE("underflow: with the floor the bound is never beaten, and a zero magnitude proves zero") {
  for (const int precision : {4, 6})
    for (const stage_case &c : all_stages()) {
      const underflow_range range = underflow_of(c, precision);
      tiny::format = range.format;
      for (int i = 0; i < c.signs; ++i) {
        INFO(c.name << ", sign " << i << ", " << precision << " bits, least exponent " << range.format.lowest);
        random_numbers random(static_cast<std::uint64_t>(i));
        bool zero = true, right = true;
        const double best = climb(c, range.numbers, random, 3, effort(500), [&](sample x) {
          x.scale = range.format.lowest;
          // Leaves that are zero, and sets of leaves that are all subnormal.
          if (random.one_in(20))
            for (std::int64_t &n : x.numbers)
              n = random.integer(-1, 1) * n % 8;
          const outcome o = judge(c, x, i, range.floor);
          zero = zero && o.zero_is_zero;
          right = right && o.sign_is_right;
          return o.ratio;
        });
        CHECK(best <= 1 + 1e-12);
        CHECK(zero);
        CHECK(right);
      }
    }
}

TEST_CASE("underflow: the emitted floors follow the rule") {
  for (const stage_case &c : all_stages()) {
    INFO(c.name);
    CHECK(c.floor_fp32 == -((149 - 2 * 24 + 1) / c.degree));
    CHECK(c.floor_fp64 * c.degree >= -1074 + 2 * 53 - 1);
  }
}

TEST_CASE("underflow: mutation: without the floor the bound is beaten") {
  for (const stage_case &c : all_stages()) {
    const underflow_range range = underflow_of(c, 6);
    tiny::format = range.format;
    for (int i = 0; i < c.signs; ++i) {
      if (c.degree_of(i) < 2)
        continue;
      INFO(c.name << ", sign " << i);
      double best = 0;
      for (std::uint64_t seed = 0; seed < 40 && best <= 1; ++seed) {
        random_numbers random(seed);
        best = climb(c, range.numbers, random, 4, 400, [&](sample x) {
          x.scale = range.format.lowest;
          return judge(c, x, i, 0).ratio;
        });
      }
      CHECK(best > 1);
    }
  }
}
