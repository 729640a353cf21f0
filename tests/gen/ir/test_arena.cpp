// Graphs: folding and fusing keep values, and the integers of the exact rung stay below their bound.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/bound/growth.hpp"
#include "gen/passes/fuse.hpp"
#include "tests/gen/oracle/random.hpp"

using namespace meetc;
using namespace meetc::compiler_test;
using ir::node_id;
using oracle_test::random_numbers;
using poly::residency;
using polynomial = poly::poly;

TEST_CASE("the arena's folding and fusing keep the value of random programs") {
  random_numbers random(11);
  const poly::ring ring({"a", "b", "c", "d"});
  for (int round = 0; round < 300; ++round) {
    ir::program p{ir::arena({residency::a, residency::a, residency::b, residency::b}), {}};
    std::vector<node_id> made;
    std::vector<polynomial> values;
    for (int i = 0; i < 4; ++i) {
      made.push_back(p.nodes.input(i));
      values.push_back(polynomial::variable(ring, i));
    }
    for (const int q : {0, 1, -1, 2, -3}) {
      made.push_back(p.nodes.constant(q));
      values.emplace_back(ring, q);
    }
    while (made.size() < 24) {
      const auto pick = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(made.size()) - 1)); };
      const std::size_t x = pick(), y = pick(), z = pick();
      node_id id = -1;
      polynomial value(ring);
      switch (random.integer(0, 4)) {
      case 0:
        id = p.nodes.add(made[x], made[y]), value = values[x] + values[y];
        break;
      case 1:
        id = p.nodes.subtract(made[x], made[y]), value = values[x] - values[y];
        break;
      case 2:
        id = p.nodes.multiply(made[x], made[y]), value = values[x] * values[y];
        break;
      case 3:
        id = p.nodes.negate(made[x]), value = values[x].scaled(-1);
        break;
      default:
        id = p.nodes.fused(made[x], made[y], made[z]), value = values[x] * values[y] + values[z];
      }
      if (value.total_degree() > 6 || value.length() > 40)
        continue;
      made.push_back(id);
      values.push_back(value);
    }
    p.results.assign(made.end() - 5, made.end());
    const std::vector<polynomial> last(values.end() - 5, values.end());
    CHECK(ir::to_poly(p, ring) == last);
    CHECK(ir::to_poly(passes::fuse(p), ring) == last);
    std::vector<poly::rational> inputs;
    for (int i = 0; i < 4; ++i)
      inputs.push_back(random.fraction());
    const auto numbers = ir::evaluate(passes::fuse(p), inputs);
    for (std::size_t i = 0; i < last.size(); ++i)
      CHECK(numbers[i] == last[i].evaluate(inputs));
  }
}

TEST_CASE("the bound of the exact rung holds: no value outgrows it") {
  random_numbers random(12);
  for (const lower::kernel *k : default_kernels(want::made_of_signs))
    for (std::size_t stage = 0; stage < lower::stage_kinds.size(); ++stage) {
      const lower::stage *s = lower::stages(k->decision)[stage];
      const bound::stage_bounds &emitted = *lower::stages(default_bounds(k->asked.name()))[stage];
      if (s->atoms.empty())
        continue;
      INFO(k->asked.text);
      const auto bounds = bound::growths(s->code);
      REQUIRE_FALSE(bounds.empty());
      for (int round = 0; round < 20; ++round) {
        // Integers below 2^bits, most of them at the edge.
        const int bits = 7, edge = (1 << bits) - 1;
        std::vector<poly::rational> inputs;
        for (std::size_t i = 0; i < k->decision.stored_inputs.size(); ++i)
          inputs.emplace_back(random.integer(0, 2) ? (random.integer(0, 1) ? edge : -edge)
                                                   : random.integer(-edge, edge));
        ir::program all{s->code.nodes, ir::needed(s->code.nodes, s->code.results)};
        const auto values = ir::evaluate(all, inputs);
        for (std::size_t i = 0; i < values.size(); ++i) {
          const auto &bound = bounds[static_cast<std::size_t>(all.results[i])];
          const mpz_class limit = mpz_class(1) << static_cast<unsigned>(bound.degree * bits + bound.bits_more);
          if (!(abs(values[i]) < limit) || bound.degree > emitted.degree || bound.bits_more > emitted.growth)
            FAIL_CHECK("node " << all.results[i] << " outgrows its bound");
        }
      }
    }
}
