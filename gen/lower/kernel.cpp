#include "gen/lower/calls.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <stdexcept>

namespace meetc::lower {
namespace {

using lower::environment;
using lower::multivector;

// Numbers that no translation moves, for operands that are blades.
std::vector<poly::stored_number> unmoved(const std::vector<std::size_t> &sizes) {
  std::vector<poly::stored_number> out;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    for (std::size_t k = 0; k < sizes[i]; ++k)
      out.push_back({static_cast<int>(i), -1, 0, false});
  return out;
}

// A coefficient that is a node, so that a multivector's products become straight-line code as they are written.
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

// Evaluates an expression keeping its structure: every outer product becomes products of what its factors became.
class structure {
public:
  structure(lower::expander &expand, builder &code) : expand_(expand), code_(code) {}

  node_multivector evaluate(const lang::expr &e, const environment &env) {
    switch (e.kind) {
    case lang::op::outer:
      return algebra::outer(evaluate(*e.args[0], env), evaluate(*e.args[1], env));
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
  lower::expander &expand_;
  builder &code_;
};

constexpr std::size_t longest_direct = 150; // terms

std::vector<blade> sorted_blades(std::set<blade> blades) {
  std::vector<blade> out(blades.begin(), blades.end());
  std::sort(out.begin(), out.end(), algebra::in_reading_order);
  return out;
}

// The kind of the same grade with room for `blades`, the tightest first, then as declared.
const lang::kind *kind_for(const lower::model &m, const std::vector<blade> &blades) {
  const lang::kind *best = nullptr;
  std::size_t best_size = 0;
  for (const lang::kind &k : m.spec().kinds) {
    if (k.hull && !k.pad)
      continue; // segments and triangles: their blades are named line and plane
    const std::vector<blade> room = support(m, k);
    const bool fits = std::all_of(blades.begin(), blades.end(),
                                  [&](blade b) { return std::find(room.begin(), room.end(), b) != room.end(); });
    if (fits && (!best || room.size() < best_size)) {
      best = &k;
      best_size = room.size();
    }
  }
  return best;
}

program better_of(const builder &code, const std::vector<node_id> &x, const std::vector<node_id> &y) {
  const program p = code.finish(x), q = code.finish(y);
  const auto &ring = code.numbers();
  if (!(to_poly(p, ring) == to_poly(q, ring)))
    throw std::logic_error("two forms of one value differ");
  return count(p.nodes, p.results).total() <= count(q.nodes, q.results).total() ? p : q;
}

formula compile_formula(const lower::model &m, const request &r) {
  formula out;
  // On blades: every operand is a multivector with one number a basis blade of its kind's support.
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  std::vector<std::vector<blade>> supports;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    supports.push_back(support(m, *r.kinds[i]));
    sizes.push_back(supports.back().size());
    for (const blade b : supports.back())
      names.push_back(r.names[i] + '.' + m.working().name(b));
  }
  out.blade_inputs = names;
  out.numbers = std::make_shared<poly::ring>(names);
  lower::decision unused;
  lower::expander expand(m, *out.numbers, unused);
  environment env;
  for (std::size_t i = 0, at = 0; i < supports.size(); at += supports[i++].size())
    env.emplace_back(r.names[i],
                     expand.general(supports[i], {names.begin() + static_cast<std::ptrdiff_t>(at),
                                                  names.begin() + static_cast<std::ptrdiff_t>(at + sizes[i])}));
  const poly::frame blades(*out.numbers, unmoved(sizes));
  builder code(blades, prefer::operations);
  const multivector whole = expand.evaluate_multivector(*r.body, env);
  std::set<blade> where;
  for (const auto &[b, c] : whole.terms())
    where.insert(b);
  out.result = sorted_blades(where);
  std::vector<node_id> direct;
  for (const blade b : out.result) {
    out.polynomials.push_back(*whole.find(b));
    // Taken apart into hundreds of terms, a value is never cheaper than through the coefficients of its parts.
    if (whole.find(b)->length() > longest_direct)
      direct.clear();
    if (direct.size() + 1 == out.polynomials.size())
      direct.push_back(code.build(*whole.find(b)));
  }
  std::vector<node_id> composed = direct;
  if (r.body->args.size() == 1 && r.body->args[0]->kind == lang::op::call) {
    // f(g(...)): g's coefficients are values of their own, and f is taken over them.
    const multivector inner = expand.evaluate_multivector(*r.body->args[0], env);
    std::vector<std::string> inner_names;
    std::vector<blade> inner_blades;
    std::vector<node_id> leaves;
    for (const auto &[b, c] : inner.terms()) {
      inner_blades.push_back(b);
      inner_names.push_back("B." + m.working().name(b));
      leaves.push_back(code.build(c));
    }
    const poly::ring inner_ring(inner_names);
    lower::expander over(m, inner_ring, unused);
    lang::expr outer = *r.body;
    lang::expr hole = *outer.args[0];
    hole.kind = lang::op::name;
    hole.text = "B";
    hole.args.clear();
    outer.args[0] = std::make_shared<lang::expr>(hole);
    const multivector f = over.evaluate_multivector(outer, {{"B", over.general(inner_blades, inner_names)}});
    bool same = true;
    for (const auto &[b, c] : f.terms())
      same = same && where.count(b) > 0;
    if (same && f.terms().size() == whole.terms().size()) {
      composed.clear();
      for (const blade b : out.result)
        composed.push_back(code.build_over(*f.find(b), leaves));
    }
  }
  if (direct.size() < out.result.size())
    direct = composed;
  if (out.result.empty()) { // identically zero
    out.result = {0};
    out.polynomials = {poly::poly(*out.numbers)};
    direct = composed = {code.nodes().constant(0)};
  }
  out.from_blades = better_of(code, direct, composed);
  const bool number = whole.is_scalar();
  if (!number)
    out.result_kind = kind_for(m, out.result);

  // A number is also taken straight from what operands store, in differences where it can be.
  if (number) {
    const stored_ring stored = stored_numbers(m, r.names, r.kinds);
    out.stored_inputs = stored.numbers->names();
    lower::expander from_stored(m, *stored.numbers, unused);
    environment objects;
    for (std::size_t i = 0; i < r.kinds.size(); ++i)
      objects.emplace_back(r.names[i], from_stored.operand(*r.kinds[i], r.names[i] + '.'));
    const multivector v = from_stored.evaluate_multivector(*r.body, objects);
    const poly::frame local(*stored.numbers, stored.moves);
    builder lowered(local, prefer::operations);
    const poly::poly zero(*stored.numbers);
    out.from_stored = lowered.finish({lowered.build(v.is_zero() ? zero : v.terms().begin()->second)});
  }
  return out;
}

// Numbers in formulas become literals of every number type, so they stay where float64 still counts in ones.
void check_constants(const program &p, const request &r) {
  const mpz_class most = mpz_class(1) << 53;
  for (const node_id id : needed(p.nodes, p.results))
    if (p.nodes.at(id).kind == op::constant &&
        (abs(p.nodes.value(id).get_num()) > most || p.nodes.value(id).get_den() > most))
      throw spec_error(
          r.where, fmt::format("'{}' needs the number {}, which is beyond 2^53", r.text, p.nodes.value(id).get_str()));
}

stage compile_stage(const poly::frame &local, const lower::decision &signs, const std::vector<int> &atoms,
                    const request &r, bool exact) {
  stage out;
  out.atoms = atoms;
  if (atoms.empty())
    return out;
  builder code(local, prefer::accuracy);
  std::vector<node_id> results;
  for (const int a : atoms)
    results.push_back(code.build(signs.atoms()[static_cast<std::size_t>(a)], true));
  out.code = code.finish(results);
  check_constants(out.code, r);
  if (!exact)
    return out;
  const std::vector<ir::magnitude> bounds = ir::magnitudes(out.code);
  if (bounds.empty())
    throw spec_error(r.where, fmt::format("a sign of '{}' is not homogeneous in the stored numbers, which the exact "
                                          "rung needs",
                                          r.text));
  for (const node_id id : needed(out.code.nodes, out.code.results)) {
    out.degree = std::max(out.degree, bounds[static_cast<std::size_t>(id)].degree);
    out.growth = std::max(out.growth, bounds[static_cast<std::size_t>(id)].growth);
  }
  return out;
}

// The operands of a kernel that is made of signs, before its signs are known.
predicate with_operands(const lower::model &m, const request &r) {
  predicate out;
  const stored_ring stored = stored_numbers(m, r.names, r.kinds);
  out.numbers = stored.numbers;
  out.stored_inputs = stored.numbers->names();
  out.inputs_a = static_cast<int>(m.layout(*r.kinds[0]).reals.size());
  out.inputs_b = static_cast<int>(m.layout(*r.kinds[1]).reals.size());
  out.local = std::make_shared<poly::frame>(*out.numbers, stored.moves);
  return out;
}

// The sign that the body gives on stored operands; nothing when it gives something else.
std::optional<predicate> compile_sign(const lower::model &m, const request &r, bool exact) {
  if (r.kinds.size() != 2)
    return std::nullopt;
  predicate out = with_operands(m, r);
  lower::expander expand(m, *out.numbers, out.signs);
  environment env;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    env.emplace_back(r.names[i], expand.operand(*r.kinds[i], r.names[i] + '.'));
  const lower::value v = expand.evaluate(*r.body, env);
  const auto *s = std::get_if<lower::sign_value>(&v.is);
  if (!s)
    return std::nullopt;
  out.value = *s;
  std::vector<int> atoms;
  for (const auto &[atom, exponent] : s->atoms)
    atoms.push_back(atom);
  out.common = compile_stage(*out.local, out.signs, atoms, r, exact);
  out.value = out.signs.turned(out.value);
  return out;
}

} // namespace

predicate compile_predicate(const lower::model &m, const request &r, bool exact) {
  predicate out = with_operands(m, r);
  lower::expander expand(m, *out.numbers, out.signs);
  std::vector<lower::value> operands;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    operands.push_back(expand.operand(*r.kinds[i], r.names[i] + '.'));
  out.truths = expand.evaluate_predicate(*r.asked, operands, &out.taken);
  out.conditions = out.signs.conditions_of(out.truths.hit);
  out.usual = out.signs.usual(out.truths.hit);
  std::set<int> seen;
  const auto fresh = [&](const std::vector<int> &truths) {
    std::set<int> atoms;
    for (const int t : truths)
      for (const int a : out.signs.atoms_of(t, true))
        if (!seen.count(a))
          atoms.insert(a);
    seen.insert(atoms.begin(), atoms.end());
    return std::vector<int>(atoms.begin(), atoms.end());
  };
  const auto reject = fresh(out.truths.reject);
  std::vector<int> common = out.conditions;
  common.push_back(out.usual);
  const auto usual = fresh(common);
  const auto rare = fresh({out.truths.hit});
  out.reject = compile_stage(*out.local, out.signs, reject, r, exact);
  out.common = compile_stage(*out.local, out.signs, usual, r, exact);
  out.rare = compile_stage(*out.local, out.signs, rare, r, exact);
  for (sign_value &s : out.taken)
    s = out.signs.turned(s);
  find_calls(m, expand.calls(), exact, out);
  return out;
}

std::vector<blade> support(const lower::model &m, const lang::kind &k, bool declared) {
  std::set<blade> blades;
  lower::decision unused;
  const auto visit = [&](const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    for (const lang::field &f : of)
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const lower::stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    const poly::ring ring(names);
    lower::expander expand(m, ring, unused);
    environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, lower::value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    multivector v = expand.evaluate_multivector(body, env);
    if (declared)
      v = algebra::outermorphism(v, m.to_declared());
    for (const auto &[b, c] : v.terms())
      blades.insert(b);
  };
  visit(k.store, *k.blade);
  for (const lang::constructor &c : k.from)
    visit(c.of, *c.blade);
  if (blades.empty())
    throw spec_error(k.blade->where, fmt::format("the blade of '{}' is always zero", k.name));
  return sorted_blades(blades);
}

std::vector<blade_maker> makers(const lower::model &m, const lang::kind &k) {
  std::vector<blade_maker> out;
  const std::vector<blade> blades = support(m, k);
  const auto make = [&](const std::string &name, const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    std::vector<poly::stored_number> moves;
    for (const lang::field &f : of) {
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const lower::stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    }
    moves.assign(names.size(), {0, -1, 0, false});
    const poly::ring ring(names);
    lower::decision unused;
    lower::expander expand(m, ring, unused);
    environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, lower::value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    const poly::frame still(ring, moves);
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
    out.push_back({name, of, names, better_of(code, direct, structured)});
  };
  make("", k.store, *k.blade);
  for (const lang::constructor &c : k.from)
    make(c.name, c.of, *c.blade);
  return out;
}

kernel compile(const lower::model &m, const request &r, bool exact) {
  kernel out;
  out.asked = r;
  out.is_predicate = r.asked != nullptr;
  if (out.is_predicate) {
    out.decision = compile_predicate(m, r, exact);
  } else if (auto sign = compile_sign(m, r, exact)) {
    out.is_predicate = out.is_sign = true;
    out.decision = std::move(*sign);
  } else {
    out.value = compile_formula(m, r);
    check_constants(out.value.from_blades, r);
    check_constants(out.value.from_stored, r);
  }
  return out;
}

} // namespace meetc::lower
