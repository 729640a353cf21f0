// Counts of operations, and beside them of scalings by powers of two and negations.
#include "gen/ir/count.hpp"
#include "tests/catch.hpp"

using namespace meetc;
using ir::node_id;
using ir::rational;
using ir::residency;

TEST_CASE("scalings and negations are counted beside the operations, and not in their total") {
  ir::arena nodes({residency::a, residency::b, residency::pair});
  const node_id a = nodes.input(0), b = nodes.input(1), c = nodes.input(2);
  const auto counted = [&](const std::vector<node_id> &results) { return ir::count(nodes, results); };
  struct row {
    node_id root;
    int multiplications, additions, fused, scalings, negations;
  };
  const node_id half = nodes.multiply(nodes.constant(rational(1, 2)), a), minus = nodes.negate(b);
  for (const row &r :
       {row{half, 0, 0, 0, 1, 0}, row{nodes.multiply(nodes.constant(3), a), 1, 0, 0, 0, 0}, row{minus, 0, 0, 0, 0, 1},
        row{nodes.subtract(a, b), 0, 1, 0, 0, 0}, row{nodes.add(half, nodes.multiply(a, b)), 1, 1, 0, 1, 0},
        row{nodes.fused(minus, c, a), 0, 0, 1, 0, 1}, row{nodes.fused(nodes.constant(4), c, a), 0, 1, 0, 1, 0}}) {
    const ir::counts n = counted({r.root});
    CHECK(n.multiplications == r.multiplications);
    CHECK(n.additions == r.additions);
    CHECK(n.fused == r.fused);
    CHECK(n.scalings == r.scalings);
    CHECK(n.negations == r.negations);
    CHECK(n.total() == r.multiplications + r.additions + 2 * r.fused);
  }
  // A node that two results need counts once; one of another residency does not count.
  CHECK(counted({half, nodes.multiply(half, half), half}).scalings == 1);
  CHECK(ir::count(nodes, {half, minus}, residency::b).scalings == 0);
  CHECK(ir::count(nodes, {half, minus}, residency::b).negations == 1);
}
