// The bound of a formula's values, against exact values in precisions of a few bits, with a fused multiply-add and without.
#include "gen/bound/rounding_count.hpp"
#include "gen/driver.hpp"
#include "gen/ir/evaluate.hpp"
#include "gen/ir/fold.hpp"
#include "tests/gen/bound/search.hpp"

#include "tests/catch.hpp"

#include <gmpxx.h>

using namespace meetc;
using bounds_test::random_numbers;
using bounds_test::tiny;

namespace {

mpq_class exact(double d) {
  return mpq_class(d);
}

// A program on tiny numbers.
struct on_tiny {
  using value = tiny;
  const std::vector<double> &inputs;
  value input(const ir::node_ref &, int i) const { return tiny::of(inputs[static_cast<std::size_t>(i)]); }
  value constant(const ir::node_ref &, const ir::rational &q) const { return tiny::rounded({q.get_d(), 0}); }
  value negate(const ir::node_ref &, value x) const { return -x; }
  value add(const ir::node_ref &, value x, value y) const { return x + y; }
  value subtract(const ir::node_ref &, value x, value y) const { return x - y; }
  value multiply(const ir::node_ref &, value x, value y) const { return x * y; }
  value fused(const ir::node_ref &, value x, value y, value z) const { return meetc::fma(x, y, z); }
};

// M: the program on magnitudes.
struct on_magnitudes {
  using value = mpq_class;
  const std::vector<double> &inputs;
  value input(const ir::node_ref &, int i) const { return abs(exact(inputs[static_cast<std::size_t>(i)])); }
  value constant(const ir::node_ref &, const ir::rational &q) const { return abs(q); }
  value negate(const ir::node_ref &, const value &x) const { return x; }
  value add(const ir::node_ref &, const value &x, const value &y) const { return x + y; }
  value subtract(const ir::node_ref &, const value &x, const value &y) const { return x + y; }
  value multiply(const ir::node_ref &, const value &x, const value &y) const { return x * y; }
  value fused(const ir::node_ref &, const value &x, const value &y, const value &z) const { return x * y + z; }
};

// The largest share that an error takes of ((1 + u)^n - 1) M, over all results; more than 1 breaks the bound.
double share(const ir::program &p, const std::vector<double> &inputs, int n) {
  std::vector<ir::rational> numbers;
  for (const double d : inputs)
    numbers.push_back(exact(d));
  const std::vector<ir::rational> want = ir::evaluate(p, numbers);
  const std::vector<tiny> have = ir::fold_results(p, on_tiny{inputs});
  const std::vector<mpq_class> magnitudes = ir::fold_results(p, on_magnitudes{inputs});
  mpq_class factor = 1;
  const mpq_class one_and_u = 1 + mpq_class(1, 1L << tiny::format.precision);
  for (int i = 0; i < n; ++i)
    factor *= one_and_u;
  factor -= 1;
  double most = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    const mpq_class error = abs(exact(have[i].value()) - want[i]), bound = factor * magnitudes[i];
    if (error > bound)
      return bound == 0 ? 1e9 : std::max(1.0 + 1e-9, mpq_class(error / bound).get_d());
    if (bound > 0)
      most = std::max(most, mpq_class(error / bound).get_d());
  }
  return most;
}

} // namespace

TEST_CASE("every shipped formula keeps its bound in five to eight bits, fused and unfused") {
  random_numbers random(5);
  int programs = 0;
  double most = 0;
  compilation scene = load(MEETC_SCENE);
  compile_all(scene);
  for (lower::kernel &k : scene.kernels) {
    if (k.is_predicate)
      continue;
    for (const lower::kernel_program &p : lower::programs(k)) {
      const int n = bound::rounding_count(*p.code);
      ++programs;
      for (int round = 0; round < 60; ++round) {
        tiny::format = {5 + round % 4, -900};
        tiny::fusing = round % 2 == 0;
        std::vector<double> inputs;
        const int largest = (1 << tiny::format.precision) - 1;
        for (std::size_t i = 0; i < p.inputs->size(); ++i)
          inputs.push_back(std::ldexp(static_cast<double>(random.integer(-largest, largest)),
                                      static_cast<int>(random.integer(-2, 2))));
        INFO(k.asked.text << ", " << p.title << ", " << n << " roundings, " << tiny::format.precision << " bits");
        const double s = share(*p.code, inputs, n);
        CHECK(s <= 1);
        most = std::max(most, s);
      }
    }
  }
  CHECK(programs > 40);
  CHECK(most > 0.05); // the numbers are large enough to be rounded
  tiny::fusing = true;
}

TEST_CASE("with one rounding fewer the bound is broken") {
  const auto built = [](auto build) {
    ir::arena nodes(std::vector<ir::residency>(3, ir::residency::a));
    const ir::node_id a = nodes.input(0), b = nodes.input(1), c = nodes.input(2);
    const ir::node_id root = build(nodes, a, b, c);
    return ir::program{std::move(nodes), {root}};
  };
  struct row {
    const char *what;
    ir::program code;
    int roundings;
    bool fusing;
  };
  const std::vector<row> rows{
      {"a + b", built([](auto &n, auto a, auto b, auto) { return n.add(a, b); }), 1, true},
      {"a b", built([](auto &n, auto a, auto b, auto) { return n.multiply(a, b); }), 1, true},
      {"a b c", built([](auto &n, auto a, auto b, auto c) { return n.multiply(n.multiply(a, b), c); }), 2, true},
      {"(a + b) + c", built([](auto &n, auto a, auto b, auto c) { return n.add(n.add(a, b), c); }), 2, true},
      {"fma(a, b, c), unfused", built([](auto &n, auto a, auto b, auto c) { return n.fused(a, b, c); }), 2, false},
      {"(a + b) c", built([](auto &n, auto a, auto b, auto c) { return n.multiply(n.add(a, b), c); }), 2, true},
  };
  tiny::format = {4, -900};
  for (const row &r : rows) {
    INFO(r.what);
    CHECK(bound::rounding_count(r.code) == r.roundings);
    tiny::fusing = r.fusing;
    double whole = 0, mutated = 0;
    for (int a = 8; a < 16; ++a)
      for (int b = 8; b < 16; ++b)
        for (int c = 8; c < 16; ++c)
          for (const double scale : {1.0, 8.0, 16.0, 32.0, 128.0}) {
            const std::vector<double> inputs{static_cast<double>(a), static_cast<double>(b), c * scale};
            whole = std::max(whole, share(r.code, inputs, r.roundings));
            mutated = std::max(mutated, share(r.code, inputs, r.roundings - 1));
          }
    CHECK(whole <= 1);
    CHECK(mutated > 1);
  }
  tiny::fusing = true;
}

TEST_CASE("constants: a number of binary32 adds no rounding, a quotient adds its own") {
  ir::arena nodes({ir::residency::a});
  const auto times = [&](const ir::rational &q) {
    const ir::node_id root = nodes.multiply(nodes.constant(q), nodes.input(0));
    return bound::rounding_count({nodes, {root}});
  };
  CHECK(times(3) == 1);
  CHECK(times(64) == 0);
  CHECK(times(ir::rational(1, 2)) == 1); // below the normal numbers it rounds
  CHECK(times(ir::rational(1, 3)) == 2);
  CHECK(times((1 << 24) + 1) == 2);
  CHECK(times(ir::rational(3, 8)) == 1);
}
