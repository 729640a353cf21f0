#include "gen/lower/predicate/symmetric.hpp"

#include "gen/lower/expand/rewriter.hpp"

#include <numeric>

namespace meetc::lower {

bool is_symmetric(const predicate &p, const std::vector<const lang::kind *> &kinds) {
  if (kinds.size() != 2 || kinds[0] != kinds[1] || p.inputs_a != p.inputs_b)
    return false;
  std::vector<int> other(static_cast<std::size_t>(p.inputs_a + p.inputs_b));
  std::iota(other.begin(), other.begin() + p.inputs_a, p.inputs_b);
  std::iota(other.begin() + p.inputs_a, other.end(), 0);
  decision both = p.signs;
  std::vector<sign_value> images;
  for (const poly::poly &atom : p.signs.atoms())
    images.push_back(both.sign_of(atom.renamed(other, atom.in())));
  rewriter exchange(p.signs, both, images);
  const auto either = [&](const std::vector<int> &of) { return of.empty() ? both.constant(false) : both.either(of); };
  std::vector<int> rejects;
  for (const int r : p.truths.reject)
    rejects.push_back(exchange.of(r));
  return exchange.of(p.truths.hit) == p.truths.hit && either(rejects) == either(p.truths.reject);
}

} // namespace meetc::lower
