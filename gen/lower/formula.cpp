// Formulas: a multivector-valued expression on general blades, and a number on stored operands as well.
#include "gen/ir/count.hpp"
#include "gen/lower/compile.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

// Numbers that no translation moves, for operands that are blades.
std::vector<poly::stored_number> unmoved(const std::vector<std::size_t> &sizes) {
  std::vector<poly::stored_number> out;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    for (std::size_t k = 0; k < sizes[i]; ++k)
      out.push_back({static_cast<int>(i), -1, 0, false});
  return out;
}

constexpr std::size_t longest_direct = 150; // number of terms

// The kind of the same grade that has room for `blades`: the tightest one, and the first declared among equals.
const lang::kind *kind_for(const model &m, const std::vector<blade> &blades) {
  const lang::kind *best = nullptr;
  std::size_t best_size = 0;
  for (const lang::kind &k : m.spec().kinds) {
    if (k.hull && !k.pad)
      continue; // skips segments and triangles, whose blades are named line and plane
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

} // namespace

formula compile_formula(const model &m, const request &r) {
  formula out;
  // On blades, every operand is a multivector with one number for each basis blade of its kind's support.
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
  decision unused;
  expander expand(m, *out.numbers, unused);
  environment env;
  for (std::size_t i = 0, at = 0; i < supports.size(); at += supports[i++].size())
    env.emplace_back(r.names[i],
                     expand.general(supports[i], {names.begin() + static_cast<std::ptrdiff_t>(at),
                                                  names.begin() + static_cast<std::ptrdiff_t>(at + sizes[i])}));
  const poly::local_origin blades(*out.numbers, unmoved(sizes));
  builder code(blades, prefer::operations);
  const multivector whole = expand.evaluate_multivector(*r.body, env);
  std::set<blade> where;
  for (const auto &[b, c] : whole.terms())
    where.insert(b);
  out.result = sorted_blades(where);
  std::vector<node_id> direct;
  for (const blade b : out.result) {
    out.polynomials.push_back(*whole.find(b));
    // A value expanded into hundreds of terms is never cheaper than one computed from the coefficients of its parts.
    if (whole.find(b)->length() > longest_direct)
      direct.clear();
    if (direct.size() + 1 == out.polynomials.size())
      direct.push_back(code.build(*whole.find(b)));
  }
  std::vector<node_id> composed = direct;
  if (r.body->args.size() == 1 && r.body->args[0]->kind == lang::op::call) {
    // For f(g(...)), the coefficients of g are values, and f is computed from them.
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
    expander over(m, inner_ring, unused);
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
  out.result_names = named(m.working(), out.result);
  out.from_blades = better_of(code, direct, composed);
  const bool number = whole.is_scalar();
  if (!number)
    out.result_kind = kind_for(m, out.result);

  // A number is also computed directly from stored operands, in differences where possible.
  if (number) {
    const stored_ring stored = stored_numbers(m, r.names, r.kinds);
    out.stored_numbers = stored.numbers;
    out.stored_inputs = stored.numbers->names();
    expander from_stored(m, *stored.numbers, unused);
    environment objects;
    for (std::size_t i = 0; i < r.kinds.size(); ++i)
      objects.emplace_back(r.names[i], from_stored.operand(*r.kinds[i], r.names[i] + '.'));
    const multivector v = from_stored.evaluate_multivector(*r.body, objects);
    const poly::local_origin local(*stored.numbers, stored.moves);
    builder lowered(local, prefer::operations);
    const poly::poly zero(*stored.numbers);
    const poly::poly &value = v.is_zero() ? zero : v.terms().begin()->second;
    out.from_stored = lowered.finish({lowered.build(value)});
    if (r.kinds.size() == 2) {
      builder paired(local, prefer::pair);
      program p = paired.finish({paired.build(value)});
      if (ir::count(p, residency::a).total() + ir::count(p, residency::b).total() > 0)
        out.for_pairs = std::move(p);
    }
  }
  return out;
}

} // namespace meetc::lower
