// Meshes that cross themselves, for tests on each processor.
#ifndef MEETC_TESTS_RUNTIME_SELF_MADE_MESHES_HPP
#define MEETC_TESTS_RUNTIME_SELF_MADE_MESHES_HPP

#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/query/self_pairs.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <neighbours/neighbours_runtime.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace self_test {

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
