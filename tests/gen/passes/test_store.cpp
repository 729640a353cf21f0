// The pass that chooses stored values by their cost, and changes nothing else.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/evaluate.hpp"
#include "gen/passes/passes.hpp"
#include "gen/passes/store.hpp"

using namespace meetc;
using namespace meetc::compiler_test;
using ir::residency;

namespace {

struct ops {
  int multiplications, additions;
  bool operator==(const ops &) const = default;
};
ops of(const ir::counts &c) {
  return {c.multiplications + c.fused, c.additions + c.fused};
}

// a and b belong to object A, c to object B.
ir::program small() {
  return {ir::arena({residency::a, residency::a, residency::b}), {}};
}

} // namespace

TEST_CASE("store: one operation is recomputed, two are stored, and a negation costs nothing") {
  ir::program p = small();
  ir::arena &n = p.nodes;
  const auto a = n.input(0), b = n.input(1), c = n.input(2);
  const auto difference = n.subtract(a, b), square = n.multiply(difference, difference);
  p.results = {n.multiply(difference, c), n.multiply(n.negate(square), c), n.negate(square)};
  const ir::program stored = passes::store(p);
  CHECK(stored.stored == std::vector<ir::node_id>{square});
  CHECK(stored.results == p.results);
  CHECK(stored.nodes.size() == p.nodes.size());
  CHECK(of(ir::count_object(stored, residency::a)) == ops{1, 1});
  CHECK(of(ir::count_object(stored, residency::b)) == ops{0, 0});
  CHECK(of(ir::count_pair(stored)) == ops{2, 1}); // the difference is recomputed
  CHECK(of(ir::count_pair(p)) == ops{3, 1});      // nothing is stored yet
}

TEST_CASE("keep: every value of one object that a pair reads is stored, and no other") {
  ir::program p = small();
  ir::arena &n = p.nodes;
  const auto a = n.input(0), b = n.input(1), c = n.input(2);
  const auto difference = n.subtract(a, b), square = n.multiply(difference, difference);
  p.results = {n.multiply(difference, c), n.multiply(n.negate(n.multiply(square, square)), c)};
  const ir::program kept = passes::keep(p);
  CHECK(kept.stored == std::vector<ir::node_id>{difference, n.multiply(square, square)});
  CHECK(kept.results == p.results);
  CHECK(of(ir::count_pair(kept)) == ops{2, 0});
}

TEST_CASE("store: a value that only a stored value reads is not stored") {
  ir::program p = small();
  ir::arena &n = p.nodes;
  const auto a = n.input(0), b = n.input(1), c = n.input(2);
  const auto inner = n.add(n.multiply(a, b), a), outer = n.multiply(inner, inner);
  p.results = {n.multiply(outer, c)};
  CHECK(passes::store(p).stored == std::vector<ir::node_id>{outer});
}

TEST_CASE(
    "store: the reject stage of two triangles costs a pair 18 multiplications, and the rare stage stores nothing") {
  const lower::predicate &p = default_kernel("triangle_triangle").decision;
  REQUIRE(p.reject.code.stored.size() == 6);
  CHECK(of(ir::count_object(p.reject.code, residency::a)) == ops{6, 9});
  CHECK(of(ir::count_object(p.reject.code, residency::b)) == ops{6, 9});
  CHECK(of(ir::count_pair(p.reject.code)) == ops{18, 27});
  CHECK(p.common.code.stored.empty());
  CHECK(of(ir::count_pair(p.common.code)) == ops{81, 75});
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    INFO(k->asked.name());
    CHECK(k->decision.rare.code.stored.empty());
    if (k->is_sign)
      CHECK(k->decision.common.code.stored.empty()); // it does not run for most pairs of two sets
    for (const lower::stage *s : lower::stages(k->decision))
      for (const ir::node_id id : s->code.stored)
        CHECK(ir::count(s->code.nodes, {id}).total() > passes::cheapest);
  }
}

TEST_CASE("store: it is the last pass, and runs only on programs that run for most pairs") {
  CHECK(std::string(passes::all().back().name) == "store");
  CHECK(passes::all().back().only == lower::use::sets);
  const lower::predicate &p = default_kernel("triangle_triangle").decision;
  ir::program before = p.reject.code;
  before.stored.clear();
  CHECK(passes::run(before, *p.numbers).stored.empty());
  CHECK(passes::run(before, *p.numbers, {}, lower::use::sets).stored.size() == 6);
  CHECK(passes::run(before, *p.numbers, "fuse", lower::use::sets).stored.empty());
}
