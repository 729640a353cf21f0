#include "gen/lower/predicate/by_balls.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

// The enclosure of a kind whose elements are balls, or points; none where they are something else.
std::optional<enclosure> ball_of(const model &m, const lang::kind &k) {
  if (!k.position && !k.hull)
    return {};
  const enclosure of = enclosing(m, k);
  if (of.hull.size() != 1 || of.mixes_points)
    return {};
  using type = element_rule::type;
  const bool rule_holds = of.rule && (of.rule->kind == type::not_negative || of.rule->kind == type::positive) &&
                          of.rule->x == std::vector<int>{of.pad};
  return of.pad < 0 || rule_holds ? std::optional(of) : std::nullopt;
}

} // namespace

bool is_by_balls(const model &m, const predicate &p, const std::vector<const lang::kind *> &kinds) {
  if (kinds.size() != 2 || !p.truths.reject.empty())
    return false;
  const std::optional<enclosure> a = ball_of(m, *kinds[0]), b = ball_of(m, *kinds[1]);
  if (!a || !b)
    return false;
  const auto number = [&](int input) { return poly::poly::variable(*p.numbers, input); };
  const poly::poly none = number(0) - number(0);
  const poly::poly reach = (a->pad < 0 ? none : number(a->pad)) + (b->pad < 0 ? none : number(p.inputs_a + b->pad));
  poly::poly difference = reach * reach;
  for (std::size_t axis = 0; axis < a->hull[0].size(); ++axis) {
    const poly::poly way = number(a->hull[0][axis]) - number(p.inputs_a + b->hull[0][axis]);
    difference = difference - way * way;
  }
  constexpr sign_mask at_least_zero = 6;
  decision one = p.signs;
  return one.test(one.sign_of(difference), at_least_zero) == p.truths.hit;
}

} // namespace meetc::lower
