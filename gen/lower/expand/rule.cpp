#include "gen/lower/expand/rule.hpp"

#include "gen/lower/expand/expand.hpp"
#include "gen/lower/expand/stored_numbers.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

// The stored numbers of a point or direction, by axis; empty where the value is none.
std::vector<int> numbers_of(const value &v, const location &where) {
  std::vector<int> out;
  if (const auto *o = std::get_if<std::shared_ptr<const object>>(&v.is))
    for (const value &f : (*o)->fields) {
      if (!std::holds_alternative<multivector>(f.is))
        return {};
      out.push_back(input_of(f, "a coordinate", where));
    }
  return out;
}

// All stored numbers of an object.
void collect(const value &v, const location &where, std::vector<int> &out) {
  if (const auto *o = std::get_if<std::shared_ptr<const object>>(&v.is))
    for (const value &f : (*o)->fields)
      collect(f, where, out);
  else
    out.push_back(input_of(v, "a number", where));
}

bool contains(const std::vector<int> &sorted, int v) {
  return std::find(sorted.begin(), sorted.end(), v) != sorted.end();
}

} // namespace

std::optional<element_rule> rule_of(const model &m, const lang::kind &k) {
  if (!k.rule)
    return std::nullopt;
  const lang::expr &e = *k.rule;
  const stored_ring stored = stored_numbers(m, {"k"}, {&k});
  decision unused;
  expander expand(m, *stored.numbers, unused);
  const value self = expand.operand(k, "k.");
  const auto &fields = std::get<std::shared_ptr<const object>>(self.is)->fields;
  environment env;
  for (std::size_t i = 0; i < k.store.size(); ++i)
    env.emplace_back(k.store[i].name, fields[i]);
  // A stored number with the name of its kind hides the kind.
  if (std::none_of(k.store.begin(), k.store.end(), [&](const lang::field &f) { return f.name == k.name; }))
    env.emplace_back(k.name, self);
  const auto with_zero = [&](lang::op kind) {
    return e.kind == kind && e.args[1]->kind == lang::op::number && e.args[1]->text == "0";
  };
  for (const auto &[kind, type] : {std::pair(lang::op::greater_equal, element_rule::type::not_negative),
                                   std::pair(lang::op::greater, element_rule::type::positive)})
    if (with_zero(kind))
      return element_rule{type,
                          {input_of(expand.evaluate(*e.args[0], env), "what a rule compares", e.args[0]->where)},
                          {},
                          lang::print(e)};
  if (with_zero(lang::op::not_equal)) {
    element_rule out{element_rule::type::not_zero, {}, {}, lang::print(e)};
    collect(expand.evaluate(*e.args[0], env), e.args[0]->where, out.x);
    return out;
  }
  for (const auto &[kind, type] : {std::pair(lang::op::not_equal, element_rule::type::differ),
                                   std::pair(lang::op::less_equal, element_rule::type::not_above)})
    if (e.kind == kind) {
      const auto x = numbers_of(expand.evaluate(*e.args[0], env), e.args[0]->where),
                 y = numbers_of(expand.evaluate(*e.args[1], env), e.args[1]->where);
      if (!x.empty() && x.size() == y.size())
        return element_rule{type, x, y, lang::print(e)};
    }
  throw spec_error(e.where, "a kind's 'where' compares a stored number with 0, as in 'r >= 0', a stored part "
                            "with 0, as in 'N != 0', or two points, as in 'p != q' and 'low <= high'");
}

bool obeys(const std::optional<element_rule> &rule, const std::vector<rational> &row) {
  if (!rule)
    return true;
  const auto at = [&](int i) -> const rational & { return row[static_cast<std::size_t>(i)]; };
  switch (rule->kind) {
  case element_rule::type::not_negative:
    return at(rule->x[0]) >= 0;
  case element_rule::type::positive:
    return at(rule->x[0]) > 0;
  case element_rule::type::not_zero:
    return std::any_of(rule->x.begin(), rule->x.end(), [&](int i) { return at(i) != 0; });
  case element_rule::type::not_above:
    return std::equal(rule->x.begin(), rule->x.end(), rule->y.begin(), [&](int a, int b) { return at(a) <= at(b); });
  case element_rule::type::differ:
    break;
  }
  return !std::equal(rule->x.begin(), rule->x.end(), rule->y.begin(), [&](int a, int b) { return at(a) == at(b); });
}

void known_signs::add(const element_rule &rule, int first) {
  if (rule.kind == element_rule::type::not_above)
    return;
  if (rule.kind == element_rule::type::not_zero) {
    not_zero.emplace_back();
    for (const int i : rule.x) // a local variable that is a stored number has the same number as in the base ring
      not_zero.back().push_back(first + i);
    return;
  }
  if (rule.kind != element_rule::type::differ) {
    not_negative.push_back(first + rule.x[0]);
    if (rule.kind == element_rule::type::positive)
      positive.push_back(first + rule.x[0]);
    return;
  }
  // The vector between the two points: the differences of their coordinates, either way round.
  std::vector<int> components;
  for (std::size_t axis = 0; axis < rule.x.size(); ++axis)
    for (int v = 0; v < local->local().size(); ++v) {
      const poly::local_variable &d = local->info(v);
      const int x = first + rule.x[axis], y = first + rule.y[axis];
      if (d.subtrahend >= 0 && std::minmax(d.minuend, d.subtrahend) == std::minmax(x, y))
        components.push_back(v);
    }
  if (components.size() == rule.x.size())
    not_zero.push_back(std::move(components));
}

bool known_signs::is_positive(const poly::poly &p) const {
  if (!local)
    return false;
  bool any = false;
  std::vector<int> squared; // the variables of terms that are a positive number times an even power of one variable
  for (const poly::term &t : local->lower(p).terms()) {
    if (t.coefficient < 0)
      return false;
    bool of_positive = true;
    for (const poly::power &f : t.factors) {
      // A local variable that is a stored number has the same number as in the base ring.
      if (f.exponent % 2 && !contains(not_negative, f.variable))
        return false;
      of_positive = of_positive && contains(positive, f.variable);
    }
    any = any || of_positive;
    if (t.factors.size() == 1 && t.factors[0].exponent % 2 == 0)
      squared.push_back(t.factors[0].variable);
  }
  return any || std::any_of(not_zero.begin(), not_zero.end(), [&](const std::vector<int> &vector) {
           return std::all_of(vector.begin(), vector.end(), [&](int v) { return contains(squared, v); });
         });
}

} // namespace meetc::lower
