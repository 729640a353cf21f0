// The blades of kinds: where they can be non-zero, and how they are computed from stored numbers.
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {

// A coefficient that is a node. The products of multivectors thus become straight-line code.
struct node_coefficient {
  arena *nodes;
  node_id at;
  friend node_coefficient operator+(const node_coefficient &a, const node_coefficient &b) {
    return {a.nodes, a.nodes->add(a.at, b.at)};
  }
  friend node_coefficient operator*(const node_coefficient &a, const node_coefficient &b) {
    return {a.nodes, a.nodes->multiply(a.at, b.at)};
  }
  node_coefficient scaled(const rational &q) const { return {nodes, nodes->multiply(nodes->constant(q), at)}; }
  bool is_zero() const { return nodes->is_constant(at, 0); }
};
using node_multivector = algebra::multivector<node_coefficient>;

// Evaluates an expression and keeps its structure: an outer product multiplies the values of its factors.
class structure {
public:
  structure(expander &expand, builder &code) : expand_(expand), code_(code) {}

  node_multivector evaluate(const lang::expr &e, const environment &env) {
    switch (e.kind) {
    case lang::op::outer:
      return algebra::outer(expand_.basis(), evaluate(*e.args[0], env), evaluate(*e.args[1], env));
    case lang::op::multiply:
      return algebra::geometric(expand_.basis(), evaluate(*e.args[0], env), evaluate(*e.args[1], env));
    case lang::op::negate:
      return evaluate(*e.args[0], env).scaled(-1);
    default: {
      node_multivector out;
      const multivector value = expand_.evaluate_multivector(e, env);
      for (const auto &[at, c] : value.terms())
        out.add(at, {&code_.nodes(), code_.build(c)});
      return out;
    }
    }
  }

private:
  expander &expand_;
  builder &code_;
};

} // namespace

std::vector<blade> sorted_blades(const metric &basis, const std::set<blade> &blades) {
  std::vector<blade> out(blades.begin(), blades.end());
  std::sort(out.begin(), out.end(), [&](blade a, blade b) { return basis.before(a, b); });
  return out;
}

std::vector<blade> support(const model &m, const lang::kind &k, bool declared) {
  std::set<blade> blades;
  decision unused;
  const auto visit = [&](const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    for (const lang::field &f : of)
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    const poly::ring ring(names);
    expander expand(m, ring, unused);
    environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    multivector v = expand.evaluate_multivector(body, env);
    if (declared)
      v = m.in_declared(v);
    for (const auto &[b, c] : v.terms())
      blades.insert(b);
  };
  visit(k.store, *k.blade);
  for (const lang::constructor &c : k.from)
    visit(c.of, *c.blade);
  if (blades.empty())
    throw spec_error(k.blade->where, fmt::format("the blade of '{}' is always zero", k.name));
  return sorted_blades(declared ? m.declared() : m.working(), blades);
}

std::vector<blade_maker> makers(const model &m, const lang::kind &k) {
  std::vector<blade_maker> out;
  const std::vector<blade> blades = support(m, k);
  const auto make = [&](const std::string &name, const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    std::vector<poly::stored_number> moves;
    for (const lang::field &f : of) {
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    }
    moves.assign(names.size(), {0, -1, 0, false});
    auto numbers = std::make_shared<poly::ring>(names);
    const poly::ring &ring = *numbers;
    decision unused;
    expander expand(m, ring, unused);
    environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    const poly::local_origin still(ring, moves);
    builder code(still, prefer::operations);
    const multivector v = expand.evaluate_multivector(body, env);
    const node_multivector written = structure(expand, code).evaluate(body, env);
    std::vector<node_id> direct, structured;
    for (const blade b : blades) {
      const poly::poly *c = v.find(b);
      direct.push_back(c ? code.build(*c) : code.nodes().constant(0));
      const node_coefficient *w = written.find(b);
      structured.push_back(w ? w->at : code.nodes().constant(0));
    }
    out.push_back({name, lang::print(body), of, names, best_of(code, {direct, structured}), std::move(numbers)});
  };
  make("", k.store, *k.blade);
  for (const lang::constructor &c : k.from)
    make(c.name, c.of, *c.blade);
  return out;
}

} // namespace meetc::lower
