// Bounded kinds: hull, pad and rule as positions in the stored row.
#include "gen/dag/kernel.hpp"

#include <fmt/format.h>

namespace meetc::dag {
namespace {
int input_of(const decide::value &v, const char *what, const location &where) {
  const auto *m = std::get_if<decide::multivector>(&v.is);
  if (m && m->is_scalar() && !m->is_zero()) {
    const auto terms = m->terms().begin()->second.terms();
    if (terms.size() == 1 && terms[0].coefficient == 1 && terms[0].factors.size() == 1 &&
        terms[0].factors[0].exponent == 1)
      return terms[0].factors[0].variable;
  }
  throw spec_error(where, fmt::format("{} must be a stored number", what));
}
} // namespace

enclosure enclosing(const decide::model &m, const spec::kind &k) {
  enclosure out;
  const stored_ring stored = stored_numbers(m, {"k"}, {&k});
  decide::decision unused;
  decide::expander expand(m, *stored.numbers, unused);
  const decide::value self = expand.operand(k, "k.");
  decide::environment env;
  const auto &object = *std::get<std::shared_ptr<const decide::object>>(self.is);
  for (std::size_t i = 0; i < k.store.size(); ++i)
    env.emplace_back(k.store[i].name, object.fields[i]);
  const auto add_point = [&](const decide::object &p, const location &where) {
    if (!p.kind->position)
      throw spec_error(where, fmt::format("a hull is made of points, not of a {}", p.kind->name));
    std::vector<int> axes;
    for (const decide::value &f : p.fields)
      axes.push_back(input_of(f, "a hull's coordinate", where));
    out.hull.push_back(std::move(axes));
  };
  if (k.position)
    add_point(object, k.where);
  if (k.hull) {
    const decide::value hull = expand.evaluate(*k.hull, env);
    const auto *points = std::get_if<std::shared_ptr<const decide::list>>(&hull.is);
    if (!points)
      throw spec_error(k.hull->where, "a hull is a list of points, as in '[p, q]'");
    for (const decide::value &p : **points) {
      const auto *o = std::get_if<std::shared_ptr<const decide::object>>(&p.is);
      if (!o)
        throw spec_error(k.hull->where, "a hull is a list of points, as in '[p, q]'");
      add_point(**o, k.hull->where);
    }
  }
  if (k.pad)
    out.pad = input_of(expand.evaluate(*k.pad, env), "a pad", k.pad->where);
  if (k.rule) {
    const spec::expr &e = *k.rule;
    const std::string text = spec::print(e);
    static const std::vector<std::pair<spec::op, const char *>> comparisons{{spec::op::greater_equal, ">= 0"},
                                                                            {spec::op::greater, "> 0"}};
    for (const auto &[kind, symbol] : comparisons)
      if (e.kind == kind && e.args[1]->kind == spec::op::number && e.args[1]->text == "0") {
        out.rule_input = input_of(expand.evaluate(*e.args[0], env), "what a rule compares", e.args[0]->where);
        out.rule = symbol;
        out.rule_text = text;
      }
    if (out.rule.empty())
      throw spec_error(e.where, "a kind's 'where' compares a stored number with 0, as in 'r >= 0'");
  }
  return out;
}

} // namespace meetc::dag
