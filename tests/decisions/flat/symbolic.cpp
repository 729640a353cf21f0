#include "tests/decisions/flat/symbolic.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace meetc::decisions_test {
namespace {

enum class joint { constant, test, all, any, negation };
struct form {
  joint kind;
  int value = 0;          // a constant; the mask of a test
  std::vector<int> parts; // a test's atoms; formulas
  auto operator<=>(const form &) const = default;
};

struct store {
  std::vector<form> forms;
  std::map<form, formula> numbers;
};
store &stored() {
  static store s;
  return s;
}
const form &at(formula f) {
  return stored().forms[static_cast<std::size_t>(f)];
}
formula number_of(form f) {
  store &s = stored();
  const auto [where, fresh] = s.numbers.emplace(f, static_cast<formula>(s.forms.size()));
  if (fresh)
    s.forms.push_back(std::move(f));
  return where->second;
}

// `kind` over all parts: parts of the same kind are flattened, the neutral constant is left out, and the other
// constant is the result.
formula join(joint kind, const std::vector<formula> &parts) {
  const formula neutral = constant(kind == joint::all), winner = constant(kind != joint::all);
  std::set<formula> out;
  for (const formula p : parts) {
    if (p == winner)
      return winner;
    if (at(p).kind == kind)
      out.insert(at(p).parts.begin(), at(p).parts.end());
    else if (p != neutral)
      out.insert(p);
  }
  if (out.empty())
    return neutral;
  return out.size() == 1 ? *out.begin() : number_of({kind, 0, {out.begin(), out.end()}});
}

} // namespace

formula constant(bool value) {
  return number_of({joint::constant, value, {}});
}
formula test(std::vector<int> atoms, int mask) {
  std::ranges::sort(atoms);
  return number_of({joint::test, mask, std::move(atoms)});
}
formula all_of(std::vector<formula> parts) {
  return join(joint::all, parts);
}
formula any_of(std::vector<formula> parts) {
  return join(joint::any, parts);
}
formula negation(formula f) {
  const form &inner = at(f);
  if (inner.kind == joint::constant)
    return constant(inner.value == 0);
  return inner.kind == joint::negation ? inner.parts[0] : number_of({joint::negation, 0, {f}});
}

std::vector<formula> alternatives(formula f) {
  return at(f).kind == joint::any ? at(f).parts : std::vector{f};
}

formula where_false(formula f, const std::vector<formula> &untrue) {
  const form here = at(f); // a copy, because the store grows below
  for (const formula u : untrue) {
    if (u == f)
      return constant(false);
    // All of f's parts and more than all of u's: f implies u.
    if (here.kind == joint::all && at(u).kind == joint::all && std::ranges::includes(here.parts, at(u).parts))
      return constant(false);
  }
  if (here.kind == joint::constant || here.kind == joint::test)
    return f;
  std::vector<formula> parts;
  for (const formula p : here.parts)
    parts.push_back(where_false(p, untrue));
  return here.kind == joint::negation ? negation(parts[0]) : join(here.kind, parts);
}

} // namespace meetc::decisions_test
