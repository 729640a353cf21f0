// Meshes that cross themselves, and the pairs of faces that meet beyond their common corners, by exact convex geometry.
#ifndef MEETC_TESTS_RUNTIME_SELF_MESHES_HPP
#define MEETC_TESTS_RUNTIME_SELF_MESHES_HPP

#include "gen/oracle/bodies.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/query/self_pairs.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <neighbours/neighbours_runtime.hpp>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace self_test {

using pair_list = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct mesh {
  std::vector<float> xyz;
  std::vector<std::uint32_t> index;
  std::size_t faces() const { return index.size() / 3; }
  meetc::view view() const {
    return {.data = xyz.data(), .vertices = xyz.size() / 3, .index = index.data(), .elements = faces()};
  }
  // The same faces as rows, without vertices.
  std::vector<float> rows() const {
    std::vector<float> out;
    for (const std::uint32_t v : index)
      out.insert(out.end(), {xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]});
    return out;
  }
};

inline meetc::self_predicates predicates() {
  return {meetc::find_predicate(cga::catalogue(), "triangle_triangle"),
          meetc::find_predicate(neighbours::catalogue(), "beyond_corner"),
          meetc::find_predicate(neighbours::catalogue(), "beyond_edge")};
}

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

// A torus whose tube crosses itself: its section is a figure of eight.
inline mesh eight_torus(double r, int around, int across) {
  mesh m;
  const auto number = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double b = 2 * std::numbers::pi * i / around, a = 2 * std::numbers::pi * j / across;
      for (const double x :
           {(1 - r * std::cos(a)) * std::cos(b), (1 - r * std::cos(a)) * std::sin(b), r * std::sin(2 * a)})
        m.xyz.push_back(static_cast<float>(x));
      m.index.insert(m.index.end(), {number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      m.index.insert(m.index.end(), {number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return m;
}

// Faces with corners from few points of a small lattice: many are neighbours, folded, doubled, without area or crossing.
inline mesh lattice_mesh(unsigned seed, int points, int faces, int size) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  mesh m;
  const bool flat = below(4) == 0;
  for (int i = 0; i < points; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto x = static_cast<float>(k == 2 && flat ? 0 : below(size));
      m.xyz.push_back(x == 0 && below(2) == 0 ? -x : x);
    }
  for (int i = 0; i < 3 * faces; ++i)
    m.index.push_back(static_cast<std::uint32_t>(below(points)));
  return m;
}

} // namespace self_test

#endif
