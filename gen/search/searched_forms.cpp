#include "gen/search/searched_forms.hpp"

#include <algorithm>

namespace meetc::search {
namespace {

// The operand of each variable; -1 where no value holds it squared or with another of its operand.
std::vector<int> groups(const product_subject &of) {
  std::vector<int> owner(static_cast<std::size_t>(of.numbers.size()), -1);
  for (std::size_t i = 0; i < of.operands.size(); ++i)
    for (const auto &[at, c] : of.operands[i].terms())
      for (const int v : c.variables())
        owner[static_cast<std::size_t>(v)] = static_cast<int>(i);
  std::vector<char> repeated(of.operands.size());
  for (const poly::poly &p : of.values)
    for (const poly::term &t : p.terms()) {
      std::vector<int> count(of.operands.size());
      for (const poly::power &f : t.factors)
        if (const int o = owner[static_cast<std::size_t>(f.variable)]; o >= 0)
          repeated[static_cast<std::size_t>(o)] |= (count[static_cast<std::size_t>(o)] += f.exponent) > 1;
    }
  for (int &o : owner)
    if (o >= 0 && !repeated[static_cast<std::size_t>(o)])
      o = -1;
  return owner;
}

} // namespace

std::vector<found_program> searched_forms(ir::arena &nodes, const product_subject &of,
                                          const std::vector<ir::node_id> &leaves, poly::price by) {
  std::vector<found_program> out;
  const std::vector<int> group = groups(of);
  const auto search = [&](const known_form &form) {
    if (auto found = search_program(nodes, of.numbers, leaves, form.system, group, by)) {
      found->differences.insert(found->differences.end(), form.differences.begin(), form.differences.end());
      out.push_back(std::move(*found));
    }
  };
  const std::vector<known_form> known = product_forms(of);
  if (known.empty() || of.values.size() > 1) // a square of a product is cheaper in its known form than expanded
    search({system_of(of.numbers, of.values), {}});
  for (const known_form &form : known)
    search(form);
  if (!of.relations.empty())
    search({system_of(of.numbers, of.values, of.relations), {}});
  return out;
}

bool repeats_an_operand(const product_subject &of) {
  const std::vector<int> group = groups(of);
  return std::any_of(group.begin(), group.end(), [](int g) { return g >= 0; });
}

bool is_certified(const product_subject &of, const std::vector<certified_difference> &differences,
                  const std::vector<poly::poly> &program) {
  std::vector<poly::poly> sum = program;
  for (const certified_difference &d : differences)
    sum[d.output] = sum[d.output] + d.multiplier * of.relations[d.relation];
  return sum == of.values;
}

} // namespace meetc::search
