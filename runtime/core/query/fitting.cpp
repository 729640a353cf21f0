#include "meet/core/query/fitting.hpp"

#include "meet/core/answers/pair_list.hpp"

#include <utility>

namespace meetc {

std::vector<choice> fitting(const catalogue &all, const kind_info &a, const kind_info &b) {
  std::vector<choice> out;
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    if (p.a == &a && p.b == &b)
      out.push_back({&p, false});
    else if (p.a == &b && p.b == &a)
      out.push_back({&p, true});
  }
  return out;
}

std::optional<choice> first_for(std::span<const choice> fit, std::string_view mode) {
  for (const choice &c : fit)
    if (const std::string_view own = c.predicate->mode; own.empty() || own == mode)
      return c;
  return std::nullopt;
}

result turned(result found) {
  found.pairs = transposed(std::move(found.pairs));
  std::swap(found.flags.a, found.flags.b);
  std::swap(found.counts.a, found.counts.b);
  std::swap(found.rungs.left_box_a, found.rungs.left_box_b);
  return found;
}

} // namespace meetc
