// The magnitude is that of the graph as scheduled. A mutation replaces it by that of the expanded polynomial, in which
// terms that the graph computes have cancelled. The bound is then beaten, by any factor.
#include "gen/ir/evaluate.hpp"
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"
#include "tests/gen/bound/search.hpp"

#include <map>

using namespace meetc::bounds_test;
using meetc::ir::node_id;
using meetc::ir::op;

namespace {

// Sign i as a polynomial in the stage's leaves.
struct expanded {
  meetc::poly::ring leaves;
  std::vector<meetc::poly::term> terms;

  expanded(const stage_case &c, int i) : leaves(names(c)) {
    const meetc::ir::program &from = *c.code;
    std::vector<meetc::poly::residency> where;
    for (const meetc::bound::leaf &l : c.bounds->leaves)
      where.push_back(l.where);
    meetc::ir::program out{meetc::ir::arena(where), {}};
    std::map<node_id, node_id> moved;
    for (const node_id id : meetc::ir::needed(from.nodes, from.results)) {
      const meetc::ir::node &n = from.nodes.at(id);
      const auto at = [&](node_id x) { return moved.at(x); };
      if (const auto l = meetc::bound::leaf_at(from.nodes, id)) {
        const auto found = std::find(c.bounds->leaves.begin(), c.bounds->leaves.end(), *l);
        if (found != c.bounds->leaves.end())
          moved[id] = out.nodes.input(static_cast<int>(found - c.bounds->leaves.begin()));
        continue;
      }
      moved[id] = n.kind == op::constant   ? out.nodes.constant(from.nodes.value(id))
                  : n.kind == op::negate   ? out.nodes.negate(at(n.a))
                  : n.kind == op::add      ? out.nodes.add(at(n.a), at(n.b))
                  : n.kind == op::subtract ? out.nodes.subtract(at(n.a), at(n.b))
                  : n.kind == op::multiply ? out.nodes.multiply(at(n.a), at(n.b))
                                           : out.nodes.fused(at(n.a), at(n.b), at(n.c));
    }
    out.results.push_back(moved.at(from.results[static_cast<std::size_t>(i)]));
    terms = meetc::ir::to_poly(out, leaves).front().terms();
  }

  // The sum of the terms' magnitudes, for leaves as computed.
  double magnitude(const stage_case &c, const sample &s) const {
    double sum = 0;
    for (const meetc::poly::term &t : terms) {
      double product = std::abs(t.coefficient.get_d());
      for (const meetc::poly::power &f : t.factors) {
        const meetc::bound::leaf &l = c.bounds->leaves[static_cast<std::size_t>(f.variable)];
        const auto number = [&](int k) { return static_cast<double>(s.numbers[static_cast<std::size_t>(k)]); };
        const double exact = number(l.minuend) - (l.subtrahend >= 0 ? number(l.subtrahend) : 0);
        product *= std::pow(std::abs(tiny::rounded({exact, 0}).value()), f.exponent);
      }
      sum += product;
    }
    return sum;
  }

private:
  static std::vector<std::string> names(const stage_case &c) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < c.bounds->leaves.size(); ++i)
      out.push_back(std::to_string(i));
    return out;
  }
};

} // namespace

TEST_CASE("expanded: mutation: the magnitude of the expanded polynomial is beaten where terms cancel") {
  tiny::format = {11, -900};
  int cancelling = 0, beaten = 0;
  for (const stage_case &c : all_stages())
    for (int i = 0; i < c.signs; ++i) {
      const expanded e(c, i);
      random_numbers random(static_cast<std::uint64_t>(i));
      const number_range range{11, std::min(c.bits(), 18)};
      // Whether it differs from the graph's magnitude at all.
      bool differs = false;
      for (int n = 0; n < 20 && !differs; ++n) {
        const sample s = any_sample(c, range, random);
        const auto m = static_cast<double>(run_of_stage(c, s, 0).magnitude(i));
        differs = e.magnitude(c, s) < 0.99 * m;
      }
      if (!differs)
        continue;
      ++cancelling;
      const int theta = c.bounds->fp32[static_cast<std::size_t>(i)].theta;
      const double growth = rounding_growth(theta, power_of_two(-11)).get_d();
      const double best = climb(c, range, random, 6, 600, [&](const sample &s) {
        const auto error = static_cast<double>(run_of_stage(c, s, 0).error(i));
        return error == 0 ? 0 : error / (growth * (e.magnitude(c, s) + 1e-9));
      });
      INFO(c.name << ", sign " << i << ": " << best);
      beaten += best > 1;
    }
  INFO(beaten << " of " << cancelling);
  CHECK(cancelling > 0);
  CHECK(beaten > 0);
}

// The textbook case: a(b + c) - ab equals ac.
TEST_CASE("expanded: a(b + c) - ab has an error of hundreds of times the bound of ac") {
  tiny::format = {11, -900};
  const double u = 0x1p-11;
  // theta: b + c 1, a(b + c) 2, the difference 3, its last rounding not counted.
  const double growth = rounding_growth(2, power_of_two(-11)).get_d();
  random_numbers random(5);
  double of_graph = 0, of_polynomial = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto number = [&](int bits) { return static_cast<double>(random.integer(1, (1 << bits) - 1)); };
    const double a = number(11), b = number(11) * 0x1p11, c = number(i % 12 + 1);
    const tiny x = tiny::of(a), y = tiny::of(b), z = tiny::of(c);
    const tiny v = x * (y + z) - x * y;
    const double error = std::abs(v.unrounded().high + v.unrounded().low - a * c);
    of_graph = std::max(of_graph, error / (growth * (a * (b + c) + a * b)));
    of_polynomial = std::max(of_polynomial, error / (growth * a * c));
  }
  CHECK(of_graph <= 1);
  CHECK(of_graph > u);
  CHECK(of_polynomial > 400);
}
