// Every pass leaves the polynomial as it was: to_poly(pass(p)) equals what was asked for, exactly.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/bound/growth.hpp"
#include "gen/passes/fuse.hpp"

#include <algorithm>

using namespace meetc;
using namespace meetc::compiler_test;
using ir::node_id;
using polynomial = poly::poly;

namespace {

std::vector<const lower::stage *> stages(const lower::predicate &p) {
  std::vector<const lower::stage *> out;
  for (const lower::stage *s : {&p.reject, &p.common, &p.rare})
    if (!s->atoms.empty())
      out.push_back(s);
  return out;
}

// The local origin of a formula on stored operands.
struct stored_origin {
  lower::stored_ring ring;
  poly::local_origin origin;
  explicit stored_origin(const lower::request &r)
      : ring(lower::stored_numbers(*default_scene().model, r.names, r.kinds)), origin(*ring.numbers, ring.moves) {}
};

// The request's value in stored numbers, expanded without any pass.
polynomial expand_stored(const lower::request &r, const poly::ring &ring) {
  lower::decision unused;
  lower::expander expand(*default_scene().model, ring, unused);
  lower::environment env;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    env.emplace_back(r.names[i], expand.operand(*r.kinds[i], r.names[i] + '.'));
  const auto value = expand.evaluate_multivector(*r.body, env);
  REQUIRE(value.is_scalar());
  return value.is_zero() ? polynomial(ring) : value.terms().begin()->second;
}

polynomial component(const poly::local_origin &f, int vector, std::size_t axis) {
  return polynomial::variable(f.local(), f.vector(vector)[axis]);
}
polynomial expand(const poly::local_origin &f, const poly::invariant &q) {
  using type = poly::invariant::type;
  const auto cross = [&](std::size_t a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    return component(f, q.i, b) * component(f, q.j, c) - component(f, q.i, c) * component(f, q.j, b);
  };
  if (q.kind == type::number)
    return polynomial::variable(f.local(), q.i);
  polynomial sum(f.local());
  for (std::size_t a = 0; a < f.vector(q.i).size(); ++a)
    sum = sum + (q.kind == type::dot      ? component(f, q.i, a) * component(f, q.j, a)
                 : q.kind == type::triple ? cross(a) * component(f, q.k, a)
                                          : cross(a) * cross(a));
  return sum;
}

// Whether a base variable is a coordinate: some difference is taken of it.
bool moves(const poly::local_origin &f, int base) {
  for (int v = 0; v < f.local().size(); ++v)
    if (f.info(v).subtrahend >= 0 && (f.info(v).subtrahend == base || f.info(v).minuend == base))
      return true;
  return false;
}

// lower and raise are inverse; vector forms expand to the same polynomial; an invariant polynomial reads no position.
void check_local_origin(const poly::local_origin &f, const polynomial &p) {
  const polynomial lowered = f.lower(p);
  CHECK(f.raise(lowered) == p);
  if (f.is_invariant(p))
    for (const int v : lowered.variables()) // a bare variable is moved by no translation
      CHECK((f.info(v).subtrahend >= 0 || !moves(f, f.info(v).minuend)));
  for (const poly::vector_form &form : poly::vector_forms(f, lowered)) {
    std::vector<polynomial> images;
    for (const poly::invariant &q : form.invariants)
      images.push_back(expand(f, q));
    CHECK(form.form.substitute(images, f.local()) == lowered);
  }
}

// A node's residency is the join over the inputs on which it depends, found by walking the graph.
void check_residency(const ir::program &p, int inputs_a) {
  std::vector<int> reads(p.nodes.size());
  for (const node_id id : ir::needed(p.nodes, p.results)) {
    const ir::node &n = p.nodes.at(id);
    int &mine = reads[static_cast<std::size_t>(id)];
    if (n.kind == ir::op::input)
      mine = n.a < inputs_a ? 1 : 2;
    else if (n.kind != ir::op::constant)
      for (const node_id operand : {n.a, n.b, n.c})
        if (operand >= 0) {
          CHECK(operand < id); // ids grow from operands to results
          mine |= reads[static_cast<std::size_t>(operand)];
        }
    if (static_cast<int>(p.nodes.where(id)) != mine)
      FAIL_CHECK("node " << id << " is marked " << static_cast<int>(p.nodes.where(id)) << " and reads " << mine);
  }
}

} // namespace

TEST_CASE("stages compute the polynomials of their atoms, exactly") {
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    INFO(k->asked.text);
    std::vector<int> all;
    for (const lower::stage *s : stages(k->decision)) {
      const auto have = ir::to_poly(s->code, *k->decision.numbers);
      REQUIRE(have.size() == s->atoms.size());
      for (std::size_t i = 0; i < have.size(); ++i)
        CHECK(have[i] == k->decision.signs.atoms()[static_cast<std::size_t>(s->atoms[i])]);
      const auto again = passes::fuse(s->code);
      CHECK(ir::to_poly(again, *k->decision.numbers) == have);
      check_residency(s->code, k->decision.inputs_a);
      all.insert(all.end(), s->atoms.begin(), s->atoms.end());
    }
    // Every atom that the decision reads belongs to exactly one stage.
    std::sort(all.begin(), all.end());
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
    if (k->is_sign)
      continue;
    for (const int a : k->decision.signs.atoms_of(k->decision.truths.hit, true))
      CHECK(std::binary_search(all.begin(), all.end(), a));
  }
}

TEST_CASE("atoms are irreducible, primitive and distinct") {
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    INFO(k->asked.text);
    const auto &atoms = k->decision.signs.atoms();
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const auto f = atoms[i].factors();
      CHECK((f.parts.size() == 1 && f.parts[0].second == 1));
      CHECK(atoms[i].primitive().first == 1);
      for (std::size_t j = 0; j < i; ++j)
        CHECK_FALSE(atoms[i] == atoms[j]);
    }
  }
}

TEST_CASE("formulas compute their polynomials, from blades and from stored numbers") {
  const lower::model &m = *default_scene().model;
  for (const lower::kernel *k : default_kernels(want::formulas)) {
    INFO(k->asked.text);
    const lower::formula &f = k->value;
    CHECK(ir::to_poly(f.from_blades, *f.numbers) == f.polynomials);
    CHECK(ir::to_poly(passes::fuse(f.from_blades), *f.numbers) == f.polynomials);
    // A kind's blade has as many coefficients as its support.
    const auto inputs_a = static_cast<int>(lower::support(m, *k->asked.kinds[0]).size());
    check_residency(f.from_blades, inputs_a);
    if (f.stored_inputs.empty())
      continue;
    const stored_origin local(k->asked);
    const polynomial expanded = expand_stored(k->asked, *local.ring.numbers);
    const auto have = ir::to_poly(f.from_stored, *local.ring.numbers);
    REQUIRE(have.size() == 1);
    CHECK(have[0] == expanded);
    check_residency(f.from_stored, static_cast<int>(m.layout(*k->asked.kinds[0]).reals.size()));
    if (!f.for_pairs.results.empty()) {
      CHECK(ir::to_poly(f.for_pairs, *local.ring.numbers) == have);
      check_residency(f.for_pairs, static_cast<int>(m.layout(*k->asked.kinds[0]).reals.size()));
    }
    // Computed in another way: the blades' own makers, put into the formula on blades.
    std::vector<polynomial> images;
    for (std::size_t i = 0; i < k->asked.kinds.size(); ++i) {
      const lower::blade_maker maker = lower::makers(m, *k->asked.kinds[i]).front();
      std::vector<std::string> names;
      std::vector<polynomial> in_pair;
      for (const std::string &n : maker.inputs) {
        names.push_back(n);
        in_pair.push_back(
            polynomial::variable(*local.ring.numbers, local.ring.numbers->find(k->asked.names[i] + '.' + n)));
      }
      const poly::ring own(names);
      for (const polynomial &c : ir::to_poly(maker.code, own))
        images.push_back(c.substitute(in_pair, *local.ring.numbers));
    }
    REQUIRE(f.polynomials.size() == 1);
    CHECK(f.polynomials[0].substitute(images, *local.ring.numbers) == expanded);
  }
}

TEST_CASE("makers compute the blades of their kinds") {
  const lower::model &m = *default_scene().model;
  for (const lang::kind &k : m.spec().kinds) {
    const auto makers = lower::makers(m, k);
    REQUIRE(makers.size() == 1 + k.from.size());
    for (const lower::blade_maker &maker : makers) {
      INFO(k.name << ' ' << maker.name);
      const lang::expr *body = k.blade.get();
      for (const lang::constructor &c : k.from)
        if (c.name == maker.name)
          body = c.blade.get();
      const poly::ring ring(maker.inputs);
      lower::decision unused;
      lower::expander expand(m, ring, unused);
      lower::environment env;
      for (const lang::field &f : maker.of)
        env.emplace_back(f.name,
                         f.type == "real"
                             ? lower::value{lower::multivector(0, polynomial::variable(ring, ring.find(f.name)))}
                             : expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
      const auto expanded = expand.evaluate_multivector(*body, env);
      const auto have = ir::to_poly(maker.code, ring);
      const auto blades = lower::support(m, k);
      REQUIRE(have.size() == blades.size());
      std::size_t found = 0;
      for (std::size_t i = 0; i < blades.size(); ++i) {
        const polynomial *c = expanded.find(blades[i]);
        found += c != nullptr;
        CHECK(have[i] == (c ? *c : polynomial(ring)));
      }
      CHECK(found == expanded.terms().size());
    }
  }
}

TEST_CASE("lowering to differences is undone by raising, and vector forms expand back") {
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    INFO(k->asked.text);
    for (const polynomial &atom : k->decision.signs.atoms()) {
      CHECK(k->decision.local->is_invariant(atom)); // every sign of the shipped predicates is geometric
      check_local_origin(*k->decision.local, atom);
    }
  }
  for (const lower::kernel *k : default_kernels(want::formulas))
    if (!k->value.stored_inputs.empty()) {
      INFO(k->asked.text);
      const stored_origin local(k->asked);
      check_local_origin(local.origin, expand_stored(k->asked, *local.ring.numbers));
    }
}

TEST_CASE("polynomials that a translation changes are not lowered") {
  const stored_origin local(default_kernel("norm2_meet_line_line").asked);
  const polynomial x = polynomial::variable(*local.ring.numbers, 0);
  CHECK_FALSE(local.origin.is_invariant(x));
  CHECK(local.origin.raise(local.origin.lower(x * x)) == x * x);
  const polynomial difference = x - polynomial::variable(*local.ring.numbers, 3);
  CHECK(local.origin.is_invariant(difference));
  CHECK(local.origin.lower(difference).length() == 1);
}
