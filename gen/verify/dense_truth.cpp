// Truths of a spec: comparisons, connectives, choices and quantifiers over lists, on numbers.
#include "gen/verify/dense_evaluator.hpp"

#include <algorithm>

namespace meetc::verify {
namespace {
using lang::op;
using oracle::rational;

bool holds(op kind, int order) {
  switch (kind) {
  case op::less:
    return order < 0;
  case op::less_equal:
    return order <= 0;
  case op::equal:
    return order == 0;
  case op::not_equal:
    return order != 0;
  case op::greater_equal:
    return order >= 0;
  default:
    return order > 0;
  }
}

// The scopes in which a quantifier evaluates its expression.
template <class Each>
void each_scope(const lang::expr &e, std::size_t binder, const dense_scope &scope, const Each &f,
                const std::function<dense_value(const lang::expr &, const dense_scope &)> &value) {
  if (binder == e.binders.size())
    return f(scope);
  for (const dense_value &item : value(*e.binders[binder].over, scope).items) {
    dense_scope inner = scope;
    inner[e.binders[binder].name] = item;
    each_scope(e, binder + 1, inner, f, value);
  }
}
} // namespace

bool dense_evaluator::truth(const lang::expr &e, const dense_scope &scope) const {
  return oracle::scalar_part(evaluate(e, scope)) != 0;
}

bool dense_evaluator::hit(const lang::predicate &p, const std::vector<dense_value> &operands) const {
  dense_scope scope;
  for (std::size_t i = 0; i < p.of.size(); ++i)
    scope[p.of[i].name] = operands[i];
  for (const lang::named_expr &l : p.lets)
    scope[l.name] = value(*l.body, scope);
  return truth(*p.hit, scope);
}

std::optional<dense_value> dense_evaluator::truth_value(const lang::expr &e, const dense_scope &scope) const {
  const auto of = [&](bool b) { return dense_value{dense_.scalar(b ? 1 : 0), {}}; };
  const auto arg = [&](std::size_t i) { return truth(*e.args[i], scope); };
  const auto in_each = [&](const auto &f) {
    each_scope(e, 0, scope, f, [this](const lang::expr &x, const dense_scope &s) { return value(x, s); });
  };
  switch (e.kind) {
  case op::less:
  case op::less_equal:
  case op::equal:
  case op::not_equal:
  case op::greater_equal:
  case op::greater: {
    const rational x = oracle::scalar_part(evaluate(*e.args[0], scope)),
                   y = oracle::scalar_part(evaluate(*e.args[1], scope));
    return of(holds(e.kind, cmp(x, y)));
  }
  case op::logical_not:
    return of(!arg(0));
  case op::logical_and:
    return of(arg(0) && arg(1));
  case op::logical_or:
    return of(arg(0) || arg(1));
  case op::conditional:
    return of(arg(0) ? arg(1) : arg(2));
  case op::list: {
    dense_value out{dense_.zero(), {}};
    for (const lang::expr_ptr &item : e.args)
      out.items.push_back(value(*item, scope));
    return out;
  }
  case op::all:
  case op::any: {
    bool every = true, some = false;
    in_each([&](const dense_scope &inner) {
      const bool here = truth(*e.args[0], inner);
      every = every && here, some = some || here;
    });
    return of(e.kind == op::all ? every : some);
  }
  case op::each: {
    dense_value out{dense_.zero(), {}};
    in_each([&](const dense_scope &inner) { out.items.push_back(value(*e.args[0], inner)); });
    return out;
  }
  default:
    return std::nullopt;
  }
}

} // namespace meetc::verify
