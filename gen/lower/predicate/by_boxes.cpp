#include "gen/lower/predicate/by_boxes.hpp"

#include <set>

namespace meetc::lower {
namespace {

struct ends {
  int low, high; // stored numbers of the kind
};

// The ends of an element's box along each axis; none where they are not one stored number each.
std::vector<ends> ends_of_box(const model &m, const lang::kind &k) {
  if (!k.position && !k.hull)
    return {};
  const enclosure of = enclosing(m, k);
  if (of.hull.empty() || of.pad >= 0)
    return {};
  std::vector<ends> out;
  for (std::size_t axis = 0; axis < of.hull.front().size(); ++axis) {
    std::set<int> numbers;
    for (const std::vector<int> &point : of.hull)
      numbers.insert(point[axis]);
    if (numbers.size() == 1) {
      out.push_back({*numbers.begin(), *numbers.begin()});
      continue;
    }
    bool known = false;
    if (of.rule && of.rule->kind == element_rule::type::not_above && numbers.size() == 2)
      for (std::size_t i = 0; i < of.rule->x.size() && !known; ++i)
        if (std::set<int>{of.rule->x[i], of.rule->y[i]} == numbers)
          out.push_back({of.rule->x[i], of.rule->y[i]}), known = true;
    if (!known)
      return {};
  }
  return out;
}

} // namespace

bool is_by_boxes(const model &m, const predicate &p, const std::vector<const lang::kind *> &kinds) {
  if (kinds.size() != 2 || !p.truths.reject.empty())
    return false;
  const std::vector<ends> a = ends_of_box(m, *kinds[0]), b = ends_of_box(m, *kinds[1]);
  if (a.empty() || a.size() != b.size())
    return false;
  constexpr sign_mask at_most_zero = 3;
  decision both = p.signs;
  std::vector<int> tests;
  const auto number = [&](int input) { return poly::poly::variable(*p.numbers, input); };
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    tests.push_back(both.test(both.sign_of(number(a[axis].low) - number(p.inputs_a + b[axis].high)), at_most_zero));
    tests.push_back(both.test(both.sign_of(number(p.inputs_a + b[axis].low) - number(a[axis].high)), at_most_zero));
  }
  return both.both(tests) == p.truths.hit;
}

} // namespace meetc::lower
