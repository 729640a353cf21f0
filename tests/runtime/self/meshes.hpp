// Meshes that cross themselves, and the pairs of faces that meet beyond their common corners, by exact convex geometry.
#ifndef MEETC_TESTS_RUNTIME_SELF_MESHES_HPP
#define MEETC_TESTS_RUNTIME_SELF_MESHES_HPP

#include "gen/oracle/bodies.hpp"
#include "tests/runtime/self/made_meshes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace self_test {

using pair_list = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

inline meetc::self_result self_of(const meetc::view &elements, meetc::self_options options = {},
                                  const meetc::pose &at = {}) {
  const meetc::prepared set = meetc::prepare(elements, *predicates().apart.a, at, options.threads);
  return meetc::self_pairs(set, elements, predicates(), options);
}

inline pair_list pairs_of(const meetc::self_result &r) {
  pair_list out;
  for (const meetc::index_pair p : r.pairs)
    out.emplace_back(p.a, p.b);
  return out;
}

inline std::size_t faces_in(const pair_list &pairs) {
  std::vector<std::uint32_t> all;
  for (const auto &[a, b] : pairs)
    all.insert(all.end(), {a, b});
  std::sort(all.begin(), all.end());
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

// The truth, pair by pair. Corners are one where their coordinates are, or, unless `merge`, where their vertex is.
inline pair_list truth(const mesh &m, bool merge) {
  using meetc::oracle::hull;
  const auto corner = [&](std::size_t face, std::size_t c) { return m.index[3 * face + c]; };
  const auto point = [&](std::uint32_t v) {
    return meetc::oracle::at(m.xyz[3 * v], m.xyz[3 * v + 1], m.xyz[3 * v + 2]);
  };
  const auto same = [&](std::uint32_t v, std::uint32_t w) { return v == w || (merge && point(v) == point(w)); };
  pair_list out;
  for (std::uint32_t i = 0; i < m.faces(); ++i)
    for (std::uint32_t j = i + 1; j < m.faces(); ++j) {
      hull a, b, common;
      std::vector<std::uint32_t> seen;
      for (std::size_t c = 0; c < 3; ++c) {
        a.push_back(point(corner(i, c))), b.push_back(point(corner(j, c)));
        const std::uint32_t v = corner(i, c);
        if (std::any_of(seen.begin(), seen.end(), [&](std::uint32_t w) { return same(v, w); }))
          continue;
        seen.push_back(v);
        for (std::size_t d = 0; d < 3; ++d)
          if (same(v, corner(j, d))) {
            common.push_back(point(v));
            break;
          }
      }
      if (common.size() == 3 || meetc::oracle::meets_beyond(a, b, common))
        out.emplace_back(i, j);
    }
  return out;
}

} // namespace self_test

#endif
