// One bound for all values of a degree is never less than the bound by the magnitudes of a value's leaves, which is proved.
#include <meetc/simd/wide_decide.hpp>

#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/many_rows.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <cmath>

using namespace meetc::generated_test;

namespace {

// The emitted program of magnitudes, with a leaf for each of its own.
struct ones {
  double operator()(double) const { return 1; }
};
struct twos {
  double operator()(double) const { return 2; }
};
template <class P, class Stage, class Leaf> std::vector<double> magnitudes(const Leaf &leaf) {
  const double a[P::inputs_a] = {}, b[P::inputs_b] = {};
  std::vector<double> m(Stage::atoms);
  meetc::stage_magnitudes<Stage>(a, b, leaf, m.data());
  return m;
}

template <class P, class L> struct in_lanes { L a[P::inputs_a], b[P::inputs_b]; };
// The operands in lanes: one pair in every lane.
template <class L, class P> in_lanes<P, L> lanes_of(const float *a, const float *b) {
  in_lanes<P, L> to;
  for (int i = 0; i < P::inputs_a; ++i)
    to.a[i] = L(a[i]);
  for (int i = 0; i < P::inputs_b; ++i)
    to.b[i] = L(b[i]);
  return to;
}

struct tally {
  int less = 0, compared = 0; // errors that are less than those by leaves
  bool rounds = false;        // some error is not zero
};
// `less` is by how much the extent is taken too small.
template <class P, class A, class L> tally compare(const many_rows &r, double less) {
  using real = typename A::real;
  tally t;
  for (const meetc::index_pair pair : r.pairs) {
    const float *const row_a = r.a.data() + std::size_t{pair.a} * P::inputs_a, *const row_b =
                                                                                   r.b.data() +
                                                                                   std::size_t{pair.b} * P::inputs_b;
    const in_lanes<P, L> rows = lanes_of<L, P>(row_a, row_b);
    const L extent = meetc::extent_of<P>(rows.a, rows.b) * L(static_cast<real>(less));
    meetc::each_stage<P>([&](auto stage) {
      using S = decltype(stage);
      L error[S::atoms];
      meetc::power_errors<P, S, A>(extent, error);
      const meetc::rows_in<P, real> numbers(row_a, row_b);
      real m[S::atoms];
      constexpr real floor = meetc::power_of_two(A::template floor<S>(), real(0));
      meetc::stage_magnitudes<S>(numbers.a, numbers.b, meetc::leaf_magnitude<real>{floor}, m);
      for (int i = 0; i < S::atoms; ++i) {
        ++t.compared;
        t.rounds |= A::template factor<S>(i) > 0;
        t.less += error[i].v[0] < A::template factor<S>(i) * m[i]; // not where one of them is NaN
      }
    });
  }
  return t;
}

} // namespace

TEST_CASE("unit magnitudes are those of the emitted programs, and homogeneous") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    INFO(p.name);
    meetc::each_stage<P>([](auto stage) {
      using S = decltype(stage);
      constexpr meetc::unit_magnitudes<P, S> unit;
      STATIC_REQUIRE(unit.usable());
      const std::vector<double> one = magnitudes<P, S>(ones()), two = magnitudes<P, S>(twos());
      double most = 0;
      for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(unit.of[i] >= one[i]); // more where a leaf is the difference of two radii
        CHECK(std::ldexp(one[i], S::degree_of(static_cast<int>(i))) == two[i]);
        most = std::fmax(most, one[i]);
      }
      const auto largest = [most](double leaf) { return most * std::pow(leaf, S::degree); };
      CHECK(largest(std::ldexp(1.0, unit.highest_power(126))) <= 0x1p126);
      CHECK(largest(std::ldexp(1.0, unit.highest_power(126) + 1)) > 0x1p126);
      CHECK(largest(unit.highest(53)) < 0x1p53);
      CHECK(largest(unit.highest(53) + 1) >= 0x1p53);
    });
  });
}

TEST_CASE("the bound by a power is never less than that by leaves, and one by a quarter is") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    INFO(p.name);
    const many_rows r(p, static_cast<std::uint32_t>(effort(300)));
    const tally single = compare<P, meetc::in_fp32, meetc::lanes>(r, 1),
                wide = compare<P, meetc::in_fp64, meetc::wide_lanes>(r, 1);
    CHECK(single.less == 0);
    CHECK(single.compared > 0);
    CHECK(wide.less == 0);
    CHECK(wide.compared > 0);
    const auto is_seen = [](const tally &t) { return t.less > 0 || !t.rounds; };
    CHECK(is_seen(compare<P, meetc::in_fp32, meetc::lanes>(r, 0.25)));
    CHECK(is_seen(compare<P, meetc::in_fp64, meetc::wide_lanes>(r, 0.25)));
  });
}
