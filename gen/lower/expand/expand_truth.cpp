// Expansion of truths: comparisons, and all, any and each over lists.
#include "gen/lower/expand/expand.hpp"

#include <fmt/format.h>

namespace meetc::lower {
namespace {
using lang::op;

bool compare_ints(op kind, int a, int b) {
  switch (kind) {
  case op::less:
    return a < b;
  case op::less_equal:
    return a <= b;
  case op::equal:
    return a == b;
  case op::not_equal:
    return a != b;
  case op::greater_equal:
    return a >= b;
  default:
    return a > b;
  }
}

sign_mask mask_for(op kind, int against) {
  sign_mask mask = 0;
  for (int s = -1; s <= 1; ++s)
    if (compare_ints(kind, s, against))
      mask |= 1 << (s + 1);
  return mask;
}

} // namespace

value expander::compare(const lang::expr &e, const environment &env) {
  const value a = evaluate(*e.args[0], env), b = evaluate(*e.args[1], env);
  const auto *sa = std::get_if<sign_value>(&a.is);
  const auto *sb = std::get_if<sign_value>(&b.is);
  if (!sa && !sb) {
    const poly::poly difference = scalar_of(blade_of(a, e.args[0]->where), e.args[0]->where) -
                                  scalar_of(blade_of(b, e.args[1]->where), e.args[1]->where);
    const long before = signs_.mark();
    const sign_value s = sign_of(difference);
    signs_.describe(s, said(*e.args[0], env) + " - " + said(*e.args[1], env), before);
    return {truth{signs_.test(s, mask_for(e.kind, 0))}};
  }
  if (sa && sb) {
    std::vector<int> cases;
    for (int s = -1; s <= 1; ++s) {
      sign_mask other = 0;
      for (int t = -1; t <= 1; ++t)
        if (compare_ints(e.kind, s, t))
          other |= 1 << (t + 1);
      cases.push_back(signs_.both({signs_.test(*sa, 1 << (s + 1)), signs_.test(*sb, other)}));
    }
    return {truth{signs_.either(cases)}};
  }
  const std::size_t plain = sa ? 1 : 0;
  const poly::poly number = scalar_of(blade_of(sa ? b : a, e.args[plain]->where), e.args[plain]->where);
  if (!number.is_constant() || number.constant().get_den() != 1 || abs(number.constant()) > 1)
    throw spec_error(e.args[plain]->where, "a sign compares with -1, 0, 1 or another sign");
  const int constant = static_cast<int>(number.is_zero() ? 0 : number.constant().get_num().get_si());
  if (sa)
    return {truth{signs_.test(*sa, mask_for(e.kind, constant))}};
  sign_mask mask = 0;
  for (int s = -1; s <= 1; ++s)
    if (compare_ints(e.kind, constant, s))
      mask |= 1 << (s + 1);
  return {truth{signs_.test(*sb, mask)}};
}

value expander::quantify(const lang::expr &e, const environment &env) {
  std::vector<environment> environments{env};
  for (const lang::binder &b : e.binders) {
    std::vector<environment> next;
    for (const environment &outer : environments) {
      const value over = evaluate(*b.over, outer);
      const auto *items = std::get_if<std::shared_ptr<const list>>(&over.is);
      if (!items)
        throw spec_error(b.over->where, fmt::format("{} where a list is needed", describe(over)));
      for (const value &item : **items) {
        charge(1, b.over->where);
        next.push_back(outer);
        next.back().emplace_back(b.name, item);
      }
    }
    environments = std::move(next);
  }
  if (e.kind == op::each) {
    auto items = std::make_shared<list>();
    for (const environment &inner : environments)
      items->push_back(evaluate(*e.args[0], inner));
    return {std::shared_ptr<const list>(std::move(items))};
  }
  std::vector<int> truths;
  for (const environment &inner : environments)
    truths.push_back(truth_of(*e.args[0], inner));
  return {truth{e.kind == op::all ? signs_.both(truths) : signs_.either(truths)}};
}

} // namespace meetc::lower
