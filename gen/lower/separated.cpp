#include "gen/lower/separated.hpp"

#include <fmt/format.h>

namespace meetc::lower {

std::vector<separated> separate(const model &m, const kernel &k) {
  std::vector<separated> out;
  if (k.is_predicate) {
    const predicate &p = k.decision;
    const auto all = stages(p);
    for (std::size_t s = 0; s < all.size(); ++s)
      for (const int a : all[s]->atoms)
        out.push_back({name_of(stage_kinds[s]), fmt::format("s[{}]", out.size()),
                       poly::separate(p.signs.atoms()[static_cast<std::size_t>(a)], p.inputs_a)});
    return out;
  }
  if (k.asked.kinds.size() != 2)
    return out;
  const auto numbers_of_x = static_cast<int>(support(m, *k.asked.kinds[0]).size());
  for (std::size_t i = 0; i < k.value.result.size(); ++i)
    out.push_back({"", k.value.result_names[i].text(), poly::separate(k.value.polynomials[i], numbers_of_x)});
  return out;
}

std::vector<separated> separate(const declared_formula &f) {
  std::vector<separated> out;
  if (f.supports.size() != 2)
    return out;
  for (std::size_t i = 0; i < f.blades.size(); ++i)
    out.push_back({"", f.blades[i].text(), poly::separate(f.values[i], f.numbers_of_x)});
  out.push_back({"", "norm2", poly::separate(f.norm2, f.numbers_of_x)});
  return out;
}

} // namespace meetc::lower
