// Kernels that consist of signs: predicates with their stages, and single signs.
#include "gen/lower/kernel/compile.hpp"
#include "gen/lower/predicate/by_balls.hpp"
#include "gen/lower/predicate/by_boxes.hpp"
#include "gen/lower/predicate/calls.hpp"
#include "gen/lower/predicate/degrees.hpp"
#include "gen/lower/predicate/symmetric.hpp"

#include <algorithm>
#include <set>

namespace meetc::lower {
namespace {

stage compile_stage(const poly::local_origin &local, const decision &signs, const std::vector<int> &atoms,
                    const request &r) {
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
  return out;
}

// The operands of a kernel that consists of signs, before its signs are known.
predicate with_operands(const model &m, const request &r) {
  predicate out;
  const stored_ring stored = stored_numbers(m, r.names, r.kinds);
  out.numbers = stored.numbers;
  out.stored_inputs = stored.numbers->names();
  out.inputs_a = static_cast<int>(m.layout(*r.kinds[0]).reals.size());
  out.inputs_b = static_cast<int>(m.layout(*r.kinds[1]).reals.size());
  out.local = std::make_shared<poly::local_origin>(*out.numbers, stored.moves);
  known_signs known{out.local.get(), {}, {}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto rule = rule_of(m, *r.kinds[i]))
      known.add(*rule, i == 0 ? 0 : out.inputs_a);
  out.signs.assume(std::move(known));
  return out;
}

} // namespace

namespace {

// Whether an expression can only be a sign: sign(...), a function that is one, or a product of signs.
bool is_sign_by_form(const model &m, const lang::expr &e) {
  if (e.kind == lang::op::call) {
    const lang::function *f = m.spec().find_function(e.text);
    return e.text == "sign" || (f && is_sign_by_form(m, *f->body));
  }
  return (e.kind == lang::op::negate || e.kind == lang::op::multiply) &&
         std::all_of(e.args.begin(), e.args.end(), [&](const lang::expr_ptr &a) { return is_sign_by_form(m, *a); });
}

} // namespace

std::optional<predicate> compile_sign(const model &m, const request &r) {
  if (r.kinds.size() != 2)
    return std::nullopt;
  predicate out = with_operands(m, r);
  expander expand(m, *out.numbers, out.signs);
  environment env;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    env.emplace_back(r.names[i], expand.operand(*r.kinds[i], r.names[i] + '.'));
  value v;
  try {
    v = expand.evaluate(*r.body, env);
  } catch (const too_long &) {
    // A formula is composed of its parts; a sign is a sign of one polynomial.
    if (is_sign_by_form(m, *r.body))
      throw;
    return std::nullopt;
  }
  const auto *s = std::get_if<sign_value>(&v.is);
  if (!s)
    return std::nullopt;
  out.value = *s;
  check_degrees(r, out);
  std::vector<int> atoms;
  for (const auto &[atom, exponent] : s->atoms)
    atoms.push_back(atom);
  out.common = compile_stage(*out.local, out.signs, atoms, r);
  return out;
}

predicate compile_predicate(const model &m, const request &r) {
  predicate out = with_operands(m, r);
  expander expand(m, *out.numbers, out.signs);
  std::vector<value> operands;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    operands.push_back(expand.operand(*r.kinds[i], r.names[i] + '.'));
  out.truths = expand.evaluate_predicate(*r.asked, operands, &out.taken);
  check_degrees(r, out);
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
  out.reject = compile_stage(*out.local, out.signs, reject, r);
  out.common = compile_stage(*out.local, out.signs, usual, r);
  out.rare = compile_stage(*out.local, out.signs, rare, r);
  find_calls(m, expand.calls(), out);
  out.symmetric = is_symmetric(out, r.kinds);
  out.by_boxes = is_by_boxes(m, out, r.kinds);
  out.by_balls = is_by_balls(m, out, r.kinds);
  return out;
}

} // namespace meetc::lower
