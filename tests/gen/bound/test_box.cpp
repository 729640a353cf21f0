// The box form in tiny precision: |v^ - v| <= c alpha^a beta^b D^k, where alpha, beta and D are powers of two above the
// leaves of A, those of B and all leaves. The climb itself produces mixed scales.
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"
#include "tests/gen/bound/search.hpp"
#include "tests/generated/judge/effort.hpp"

using namespace meetc::bounds_test;
using meetc::bound::box_node;
using meetc::generated_test::effort;
using meetc::poly::residency;

namespace {

number_range range_of(const stage_case &c, int precision) {
  return {precision, std::min(c.bits(), precision + 12)};
}

double power_not_below(double x) {
  double p = 1;
  while (p < x)
    p *= 2;
  return p;
}
double power_over(double x) {
  const double p = power_not_below(x);
  return p == x ? 2 * p : p;
}

struct extents {
  double alpha, beta, d;
};
enum class rule {
  exact,    // the least powers of two that are not below the exact leaves
  computed, // alpha and beta from computed leaves: the least powers above them, and at most D
  careless, // the same, but the least powers that are not below them
};
extents extents_of(const stage_case &c, const sample &s, rule by) {
  double a = 0, b = 0, all = 0;
  for (const meetc::bound::leaf &l : c.bounds->leaves) {
    const auto number = [&](int i) { return s.numbers[static_cast<std::size_t>(i)]; };
    const std::int64_t t = number(l.minuend) - (l.subtrahend >= 0 ? number(l.subtrahend) : 0);
    const double exact = std::abs(static_cast<double>(t));
    const double size = by == rule::exact ? exact : tiny::rounded({exact, 0}).value();
    all = std::max(all, exact);
    if (l.where == residency::a)
      a = std::max(a, size);
    if (l.where == residency::b)
      b = std::max(b, size);
  }
  const double d = power_not_below(all);
  if (by == rule::computed)
    return {std::min(power_over(a), d), std::min(power_over(b), d), d};
  return {power_not_below(a), power_not_below(b), d};
}

double bound_of(const box_node &n, double c, const extents &e) {
  return c * std::pow(e.alpha, n.a) * std::pow(e.beta, n.b) * std::pow(e.d, n.pair);
}

// v^ - v| / bound at its worst. The bound is scaled only by powers of two, so doubles distinguish above from below 1 except for
// the last bits of c, which the rounding up covers.
double worst(const stage_case &c, int i, int precision, rule by, int starts, int steps, std::uint64_t seed,
             bool contracted = false, double enough = std::numeric_limits<double>::infinity()) {
  tiny::format = {precision, -900, contracted};
  const meetc::ir::folded<box_node> nodes = meetc::bound::box_nodes(*c.code, precision, -900);
  const box_node &n = nodes.at(c.code->results[static_cast<std::size_t>(i)]);
  const double bound = n.unrounded_error.get_d() * (1 + 0x1p-50);
  random_numbers random(seed);
  const auto share_of_bound = [&](const sample &x) {
    const run_of_stage r(c, x, 0);
    const auto error = static_cast<double>(r.error(i));
    const extents e = extents_of(c, x, by);
    return error == 0 ? 0 : bound == 0 ? 1e9 : error / bound_of(n, bound, e);
  };
  return climb(c, range_of(c, precision), random, starts, steps, share_of_bound, enough);
}

} // namespace

TEST_CASE("box form: no sign's bound is beaten, static or per object") {
  for (const stage_case &c : both_schedules())
    for (int i = 0; i < c.signs; ++i) {
      INFO(c.name << ", sign " << i);
      double top = 0;
      for (const int precision : {4, 6, 8}) {
        const auto seed = static_cast<std::uint64_t>(1000 * precision + i);
        const double exact = worst(c, i, precision, rule::exact, 3, steps_of_climb(effort(700)), seed);
        CHECK(exact <= 1);
        CHECK(worst(c, i, precision, rule::computed, 2, steps_of_climb(effort(500)), seed) <= 1);
        CHECK(worst(c, i, precision, rule::computed, 2, steps_of_climb(effort(500)), seed, true) <= 1);
        top = std::max(top, exact);
      }
      if (c.box(i).c == 0)
        CHECK(top == 0);
    }
}

TEST_CASE("box form: the runtime's powers of two are those of the rule") {
  random_numbers random(1);
  bool not_below = true, over = true;
  for (int i = 0; i < 10000; ++i) {
    const auto m = static_cast<float>(random.integer(0, 1) ? random.integer(0, 0xffffff) : 1 << random.integer(0, 23));
    const float x = std::ldexp(m, static_cast<int>(random.integer(-140, 80)));
    if (x < 0x1p-126F)
      continue;
    const auto d = static_cast<double>(x);
    int e;
    std::frexp(d, &e);
    over = over && static_cast<double>(meetc::power_over(x)) == std::ldexp(1.0, e);
    not_below = not_below &&
                static_cast<double>(meetc::power_above(x)) == std::ldexp(1.0, d == std::ldexp(1.0, e - 1) ? e - 1 : e);
  }
  CHECK(over);
  CHECK(not_below);
  CHECK(meetc::power_over(0) > 0);
}

// A computed extent of exactly alpha may belong to a leaf that is larger and was rounded down. Its error is then that
// of the next binade, twice as large, so alpha has to be above the computed extent.
TEST_CASE("box form: mutation: extents not above computed ones are beaten") {
  double most = 0;
  for (const stage_case &c : all_stages())
    for (int i = 0; i < c.signs && most <= 1; ++i)
      for (std::uint64_t seed = 0; seed < 4; ++seed)
        if (c.box(i).c > 0 && c.box(i).pair < c.degree_of(i))
          most = std::max(most, worst(c, i, 6, rule::careless, 6, 1500, seed, false, 1));
  CHECK(most > 1);
}

// The recurrence adds up worst cases that cannot all occur together, the less so the higher the degree: the leaves of a
// triangle in a box cannot all be as long as the box. A quarter of c is beaten for every sign of degree 2 and 3, and
// for some of degree 4 and 6.
TEST_CASE("box form: mutation: a quarter of c is beaten") {
  int low = 0, high = 0;
  for (const stage_case &c : both_schedules())
    for (int i = 0; i < c.signs; ++i) {
      if (c.box(i).c == 0)
        continue;
      INFO(c.name << ", sign " << i << ", degree " << c.degree_of(i));
      const bool is_low = c.degree_of(i) <= 3;
      double most = 0;
      for (std::uint64_t seed = 0; seed < (is_low ? 200 : 4) && most <= 0.25; ++seed)
        most = std::max(most, worst(c, i, 8, rule::exact, 3, 1500, seed, false, 0.25));
      if (is_low)
        CHECK(most > 0.25);
      (is_low ? low : high) += most > 0.25;
    }
  CHECK(low > 200);
  CHECK(high > 0);
}

// A term in alpha next to one in D, as in |a|^2 - (b - a)^2: the smaller one is bounded by D as well, never by alpha
// alone.
TEST_CASE("box form: sums of mixed scales take the larger scale") {
  int mixed = 0;
  for (const stage_case &c : all_stages()) {
    const meetc::ir::folded<box_node> nodes = meetc::bound::box_nodes(*c.code, 8, -900);
    for (const meetc::ir::node_id id : meetc::ir::needed(c.code->nodes, c.code->results)) {
      const meetc::ir::node &n = c.code->nodes.at(id);
      if (n.kind != meetc::ir::op::add && n.kind != meetc::ir::op::subtract)
        continue;
      if (meetc::bound::leaf_at(c.code->nodes, id))
        continue;
      const box_node &s = nodes.at(id), &x = nodes.at(n.a), &y = nodes.at(n.b);
      mixed += x.a != y.a || x.b != y.b;
      CHECK(s.a <= std::min(x.a, y.a));
      CHECK(s.b <= std::min(x.b, y.b));
      CHECK(s.a + s.b + s.pair == x.a + x.b + x.pair);
    }
  }
  CHECK(mixed > 0);
}
