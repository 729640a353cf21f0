// The kind of a formula's value, by its grades and by what is zero.
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

// Whether the coefficient on `at` is one number other than 0, whatever is stored, by every constructor of the kind.
bool is_fixed(const std::vector<blade_maker> &makers, const std::vector<blade> &support, blade at) {
  const auto i = static_cast<std::size_t>(std::find(support.begin(), support.end(), at) - support.begin());
  return std::all_of(makers.begin(), makers.end(), [i](const blade_maker &m) {
    const node &n = m.code.nodes.at(m.code.results.at(i));
    return n.kind == op::constant && m.code.nodes.value(m.code.results[i]) != 0;
  });
}

bool fits(const model &m, const lang::kind &k, const std::vector<blade> &room, const std::vector<blade> &blades) {
  const auto is_in = [](const std::vector<blade> &all, blade b) {
    return std::find(all.begin(), all.end(), b) != all.end();
  };
  if (!std::all_of(blades.begin(), blades.end(), [&](blade b) { return is_in(room, b); }))
    return false;
  if (room.size() == blades.size())
    return true;
  const std::vector<blade_maker> all = makers(m, k);
  return std::all_of(room.begin(), room.end(), [&](blade b) { return is_in(blades, b) || !is_fixed(all, room, b); });
}

} // namespace

const lang::kind *kind_of_value(const model &m, const std::vector<blade> &blades) {
  const lang::kind *best = nullptr;
  std::size_t best_size = 0;
  for (const lang::kind &k : m.spec().kinds) {
    if (k.hull && !k.pad)
      continue; // skips segments and triangles, whose blades are named line and plane
    const std::vector<blade> room = support(m, k);
    if ((!best || room.size() < best_size) && fits(m, k, room, blades)) {
      best = &k;
      best_size = room.size();
    }
  }
  return best;
}

} // namespace meetc::lower
