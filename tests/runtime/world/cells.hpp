// Solids made of cubic cells of a lattice, their surfaces, and what is true of two of them by counting cells.
#pragma once
#include "meet/core/views/view.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace world_test {

using cell = std::array<int, 3>;

// A linear map of the lattice, by rows.
using lattice_map = std::array<cell, 3>;
inline constexpr lattice_map identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
inline int determinant(const lattice_map &m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct triangles {
  std::vector<float> rows; // nine numbers each
  meetc::view view() const { return {rows.data(), 0, 0, nullptr, rows.size() / 9}; }
  void turn_round(std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k)
      std::swap(rows[9 * i + 3 + k], rows[9 * i + 6 + k]);
  }
  void turn_round() {
    for (std::size_t i = 0; i < rows.size() / 9; ++i)
      turn_round(i);
  }
  void append(const triangles &more) { rows.insert(rows.end(), more.rows.begin(), more.rows.end()); }
};

struct cells {
  std::set<cell> of;
  int size = 1; // the edge of a cell, in steps of the lattice

  // The cells of a box, whose last corner is excluded.
  cells &add(cell from, cell to) {
    return each(from, to, [this](cell c) { of.insert(c); });
  }
  cells &cut(cell from, cell to) {
    return each(from, to, [this](cell c) { of.erase(c); });
  }

  // The cells of edge 1.
  std::set<cell> fine() const {
    std::set<cell> out;
    for (const cell &c : of)
      each_in(first(c), first(c, size), [&](cell f) { out.insert(f); });
    return out;
  }
  // All points of the lattice on the surface. Two surfaces touch where they share one.
  std::set<cell> surface_points() const {
    std::set<cell> out;
    for_each_side([&](cell c, int axis, int way) {
      cell from = first(c), to = first(c, size + 1);
      from[static_cast<std::size_t>(axis)] += way > 0 ? size : 0;
      to[static_cast<std::size_t>(axis)] = from[static_cast<std::size_t>(axis)] + 1;
      each_in(from, to, [&](cell p) { out.insert(p); });
    });
    return out;
  }
  // The surface after a map, with normals outwards, squares cut along a diagonal that is drawn.
  triangles surface(const lattice_map &map = identity, std::mt19937 *drawn = nullptr, float scale = 1) const {
    triangles out;
    for_each_side([&](cell c, int axis, int way) {
      const auto a = static_cast<std::size_t>(axis), u = (a + 1) % 3, v = (a + 2) % 3;
      std::array<cell, 4> corner;
      corner.fill(first(c));
      for (std::size_t i = 0; i < 4; ++i) {
        corner[i][a] += way > 0 ? size : 0;
        corner[i][u] += i == 1 || i == 2 ? size : 0;
        corner[i][v] += i >= 2 ? size : 0;
      }
      if ((way < 0) != (determinant(map) < 0))
        std::swap(corner[1], corner[3]);
      const std::size_t begin = drawn ? (*drawn)() % 2 : 0;
      for (const std::size_t i : {0, 1, 2, 0, 2, 3})
        for (const cell &row : map) {
          const cell &p = corner[(begin + i) % 4];
          out.rows.push_back(static_cast<float>(row[0] * p[0] + row[1] * p[1] + row[2] * p[2]) * scale);
        }
    });
    return out;
  }

private:
  template <class F> static void each_in(cell from, cell to, const F &f) {
    for (int x = from[0]; x < to[0]; ++x)
      for (int y = from[1]; y < to[1]; ++y)
        for (int z = from[2]; z < to[2]; ++z)
          f({x, y, z});
  }
  template <class F> cells &each(cell from, cell to, const F &f) {
    each_in(from, to, f);
    return *this;
  }
  cell first(cell c, int more = 0) const { return {c[0] * size + more, c[1] * size + more, c[2] * size + more}; }
  // Calls f(cell, axis, way) for each side of a cell behind which there is none.
  template <class F> void for_each_side(const F &f) const {
    for (const cell &c : of)
      for (int axis = 0; axis < 3; ++axis)
        for (const int way : {-1, 1}) {
          cell behind = c;
          behind[static_cast<std::size_t>(axis)] += way;
          if (!of.contains(behind))
            f(c, axis, way);
        }
  }
};

inline cells box_of(cell from, cell to) {
  return cells().add(from, to);
}

inline int below(std::mt19937 &g, int n) {
  return static_cast<int>(g() % static_cast<unsigned>(n));
}
inline lattice_map drawn_map(std::mt19937 &g) {
  lattice_map m;
  do
    for (cell &row : m)
      for (int &x : row)
        x = below(g, 5) - 2;
  while (determinant(m) == 0);
  return m;
}

// Blocks of edge 4 with holes and cavities.
inline cells drawn_blocks(std::mt19937 &g) {
  cells out;
  out.size = 4;
  const int most = 40 + below(g, 60);
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if (below(g, 100) < most)
          out.add({x, y, z}, {x + 1, y + 1, z + 1});
  if (below(g, 3) == 0)
    out.add({0, 0, 0}, {3, 3, 3}).cut({1, 1, 1}, {2, 2, 2});
  if (out.of.empty())
    out.add({1, 1, 1}, {2, 2, 2});
  return out;
}
// Small boxes among them, and hollow boxes around their cavities.
inline cells drawn_boxes(std::mt19937 &g) {
  cells out;
  for (int n = 1 + below(g, 3) / 2; n > 0; --n) {
    const cell from{below(g, 13) - 1, below(g, 13) - 1, below(g, 13) - 1};
    out.add(from, {from[0] + 1 + below(g, 2), from[1] + 1 + below(g, 2), from[2] + 1 + below(g, 2)});
  }
  if (below(g, 4) == 0) {
    const int thin = 1 + below(g, 3);
    out = box_of({thin, thin, thin}, {12 - thin, 12 - thin, 12 - thin});
    if (below(g, 2) == 0)
      out.cut({thin + 1, thin + 1, thin + 1}, {11 - thin, 11 - thin, 11 - thin});
  }
  return out;
}

// The relation of two solids whose surfaces have no point in common, by counting cells; "touching" where they have.
inline const char *relation_of(const cells &a, const cells &b) {
  const auto intersect = [](const std::set<cell> &x, const std::set<cell> &y) {
    return std::ranges::any_of(x, [&](const cell &c) { return y.contains(c); });
  };
  if (intersect(a.surface_points(), b.surface_points()))
    return "touching";
  const std::set<cell> in_a = a.fine(), in_b = b.fine();
  if (!intersect(in_a, in_b))
    return "apart";
  if (std::ranges::includes(in_b, in_a))
    return "a inside b";
  return std::ranges::includes(in_a, in_b) ? "b inside a" : "overlapping";
}

} // namespace world_test
