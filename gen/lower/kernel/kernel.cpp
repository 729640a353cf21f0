#include "gen/lower/kernel/kernel.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/residue.hpp"
#include "gen/lower/kernel/compile.hpp"
#include "gen/lower/kernel/contacts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::lower {

program best_of(const builder &code, const std::vector<std::vector<node_id>> &forms) {
  const auto operations = [&](const std::vector<node_id> &form) { return count(code.nodes(), form).total(); };
  const auto best = std::min_element(forms.begin(), forms.end(),
                                     [&](const auto &x, const auto &y) { return operations(x) < operations(y); });
  program out = code.finish(*best);
  for (auto form = forms.begin(); form != forms.end(); ++form)
    if (form != best && !ir::same_values(out, {code.nodes(), *form}, code.numbers()))
      throw std::logic_error("two forms of one value differ");
  return out;
}

void check_constants(const program &p, const request &r) {
  const mpz_class most = mpz_class(1) << 53;
  for (const node_id id : needed(p.nodes, p.results))
    if (p.nodes.at(id).kind == op::constant &&
        (abs(p.nodes.value(id).get_num()) > most || p.nodes.value(id).get_den() > most))
      throw spec_error(
          r.where, fmt::format("'{}' needs the number {}, which is beyond 2^53", r.text, p.nodes.value(id).get_str()));
}

std::vector<kernel_program> programs(kernel &k) {
  std::vector<kernel_program> out;
  if (k.is_predicate) {
    predicate &p = k.decision;
    const auto all = stages(p);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const std::size_t n = all[i]->atoms.size())
        out.push_back({fmt::format("stage of {} signs", n), &all[i]->code, p.numbers.get(), &p.stored_inputs,
                       k.is_sign || all[i] == &p.rare ? use::once : use::sets});
    return out;
  }
  formula &f = k.value;
  out.push_back({"from blades", &f.from_blades, f.numbers.get(), &f.blade_inputs});
  if (!f.prepared.results.empty())
    out.push_back({"prepared", &f.prepared, f.numbers.get(), &f.blade_inputs, use::pairs});
  if (f.stored_numbers)
    out.push_back({"from stored numbers", &f.from_stored, f.stored_numbers.get(), &f.stored_inputs});
  if (!f.for_pairs.results.empty())
    out.push_back({"for pairs", &f.for_pairs, f.stored_numbers.get(), &f.stored_inputs, use::pairs});
  return out;
}

bound::subject subject_of(const predicate &p) {
  bound::subject out{*p.numbers, *p.local, {}};
  const auto all = stages(p);
  for (std::size_t i = 0; i < all.size(); ++i) {
    out.stages[i].code = &all[i]->code;
    for (const int a : all[i]->atoms)
      out.stages[i].signs.push_back(&p.signs.atoms()[static_cast<std::size_t>(a)]);
  }
  return out;
}

namespace {

// The predicate that the kernel's function orders, if the operands are of the form that runtimes order: two points, and a pair
// of elements with three points each.
const lang::predicate *ordered_by(const model &m, const request &r) {
  const lang::function *f = function_of(m, r);
  if (!f || f->orders.empty())
    return nullptr;
  const lang::predicate &p = *m.spec().find_predicate(f->orders);
  const lang::kind &first = m.kind(p.of[0].type, p.of[0].where), &second = m.kind(p.of[1].type, p.of[1].where);
  const std::vector<lang::field> &pair = r.kinds[1]->store;
  const bool fits =
      r.kinds[0] == &first && pair.size() == 2 && pair[0].type == second.name && pair[1].type == second.name;
  if (!fits || points_of(m, first) != 2 || points_of(m, second) != 3)
    throw spec_error(
        f->orders_where,
        fmt::format("'{}' orders {} only as a function of its first operand, which has two points, and of a pair "
                    "of its second ones, which have three",
                    f->name, p.name));
  return &p;
}

} // namespace

kernel compile(const model &m, const request &r) {
  kernel out;
  out.asked = r;
  out.is_predicate = r.asked != nullptr;
  if (out.is_predicate) {
    check_contacts(m, *r.asked);
    out.decision = compile_predicate(m, r);
  } else if (auto sign = compile_sign(m, r)) {
    out.is_predicate = out.is_sign = true;
    out.decision = std::move(*sign);
    out.orders = ordered_by(m, r);
    out.sides_of = sides_of(m, r, true);
  } else {
    if (const lang::function *f = function_of(m, r); f && !f->orders.empty())
      throw spec_error(f->orders_where, fmt::format("'{}' orders {} and must be a sign", f->name, f->orders));
    sides_of(m, r, false);
    out.value = compile_formula(m, r);
    check_constants(out.value.from_blades, r);
    check_constants(out.value.prepared, r);
    check_constants(out.value.from_stored, r);
    check_constants(out.value.for_pairs, r);
  }
  return out;
}

} // namespace meetc::lower
