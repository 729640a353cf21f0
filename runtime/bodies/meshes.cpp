// Bodies that are grids or divided solids, and random clouds. See meshes.hpp. The implicit bodies are in implicit.cpp.
#include "meet/bodies/meshes.hpp"

#include "meet/bodies/detail.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace meetc::bodies {
namespace {

using namespace detail;

// The triangles of an m by n grid of vertices that closes in both directions.
void wrap(mesh &out, std::uint32_t m, std::uint32_t n) {
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t i1 = (i + 1) % m, j1 = (j + 1) % n;
      const std::uint32_t a = i * n + j, b = i1 * n + j, c = i1 * n + j1, d = i * n + j1;
      out.index.insert(out.index.end(), {a, b, c, a, c, d});
    }
}

// splitmix64 (Steele, Lea, Flood 2014).
struct generator {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; } // [0, 1)
  double signed_unit() { return 2 * unit() - 1; }
};

} // namespace

mesh subdivide(const mesh &m) {
  mesh out;
  out.xyz = m.xyz;
  out.xyz.reserve(m.xyz.size() + m.index.size() * 3 / 2 + 64);
  out.index.reserve(m.index.size() * 4);
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(m.index.size() / 2 + 16);
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
    const auto [at, fresh] = middles.try_emplace(key, static_cast<std::uint32_t>(out.xyz.size() / 3));
    if (fresh)
      for (std::size_t k = 0; k < 3; ++k) {
        const double sum = static_cast<double>(m.xyz[3 * std::size_t{a} + k]) + m.xyz[3 * std::size_t{b} + k];
        out.xyz.push_back(static_cast<float>(sum / 2));
      }
    return at->second;
  };
  for (std::size_t t = 0; t + 2 < m.index.size(); t += 3) {
    const std::uint32_t a = m.index[t], b = m.index[t + 1], c = m.index[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    out.index.insert(out.index.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return out;
}

mesh icosphere(int subdivisions) {
  // Corners (0, ±1, ±g) and their cyclic shifts.
  const double g = (1 + root(5)) / 2, l = root(1 + g * g), a = 1 / l, b = g / l;
  const std::array<vec, 12> corner{{{-a, b, 0},
                                    {a, b, 0},
                                    {-a, -b, 0},
                                    {a, -b, 0},
                                    {0, -a, b},
                                    {0, a, b},
                                    {0, -a, -b},
                                    {0, a, -b},
                                    {b, 0, -a},
                                    {b, 0, a},
                                    {-b, 0, -a},
                                    {-b, 0, a}}};
  mesh m;
  for (const vec &p : corner)
    put(m, p);
  m.index = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
             3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
  for (int s = std::clamp(subdivisions, 0, 8); s > 0; --s) {
    const std::size_t old = m.xyz.size();
    m = subdivide(m);
    for (std::size_t v = old; v < m.xyz.size(); v += 3) {
      const vec p = normal({m.xyz[v], m.xyz[v + 1], m.xyz[v + 2]});
      m.xyz[v] = round16(p.x);
      m.xyz[v + 1] = round16(p.y);
      m.xyz[v + 2] = round16(p.z);
    }
  }
  return m;
}

mesh torus(int segments, int rings) {
  const int m = std::clamp(segments, 3, 4096), n = std::clamp(rings, 3, 4096);
  mesh out;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const circle_point u = turn(i, m), v = turn(j, n);
      const double r = 1 + 0.375 * v.cosine;
      put(out, {r * u.cosine, 0.375 * v.sine, -r * u.sine});
    }
  wrap(out, static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(n));
  return out;
}

mesh knot(int segments, int rings) {
  const int m = std::clamp(segments, 48, 16384), n = std::clamp(rings, 3, 1024);
  mesh out;
  for (int i = 0; i < m; ++i) {
    // p(t) = ((2 + cos 3t) cos 2t, sin 3t, (2 + cos 3t) sin 2t) / 2, and its derivative.
    const circle_point u = turn(2 * i, m), w = turn(3 * i, m);
    const double r = 1 + 0.5 * w.cosine;
    const vec p{r * u.cosine, 0.5 * w.sine, r * u.sine};
    const vec d =
        normal({-1.5 * w.sine * u.cosine - 2 * r * u.sine, 1.5 * w.cosine, -1.5 * w.sine * u.sine + 2 * r * u.cosine});
    // The direction from the circle of the torus is never parallel to the curve, and it closes with the curve.
    const vec out_of{w.cosine * u.cosine, w.sine, w.cosine * u.sine};
    const vec side = normal(cross(d, out_of)), up = cross(side, d);
    for (int j = 0; j < n; ++j) {
      const circle_point v = turn(j, n);
      put(out, p + (0.25 * v.cosine) * side + (0.25 * v.sine) * up);
    }
  }
  wrap(out, static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(n));
  return out;
}

mesh gear(int teeth, int detail) {
  const int z = std::clamp(teeth, 5, 256), k = std::clamp(detail, 1, 16), m = 8 * z * k, n = 8 * k;
  // The radius over one tooth in eight steps, root 0 and tip 1, and the profile of a cross-section in eight steps:
  // radius between bore 0 and rim 1, and height.
  constexpr std::array<double, 8> tooth{0, 0, 0.5, 1, 1, 1, 0.5, 0};
  constexpr std::array<std::array<double, 2>, 8> profile{
      {{0, 0.25}, {0.5, 0.25}, {0.94, 0.25}, {1, 0.1875}, {1, -0.1875}, {0.94, -0.25}, {0.5, -0.25}, {0, -0.25}}};
  const double root_radius = 1 - 2.5 / z, tip_radius = 1 + 2.0 / z; // 2.25 modules of depth
  mesh out;
  for (int i = 0; i < m; ++i) {
    const int step = i / k % 8;
    const double s = static_cast<double>(i % k) / k;
    const auto at = static_cast<std::size_t>(step);
    const double height = tooth[at] + s * (tooth[(at + 1) % 8] - tooth[at]);
    const double rim = root_radius + height * (tip_radius - root_radius);
    const circle_point u = turn(i, m);
    for (int j = 0; j < n; ++j) {
      const auto at_j = static_cast<std::size_t>(j / k);
      const double t = static_cast<double>(j % k) / k;
      const auto &p = profile[at_j], &q = profile[(at_j + 1) % 8];
      const double r = 0.25 + (rim - 0.25) * (p[0] + t * (q[0] - p[0]));
      put(out, {r * u.cosine, r * u.sine, p[1] + t * (q[1] - p[1])});
    }
  }
  wrap(out, static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(n));
  for (std::size_t t = 0; t < out.index.size(); t += 3)
    std::swap(out.index[t + 1], out.index[t + 2]); // the profile runs the other way round
  return out;
}

mesh block(int nx, int ny, int nz, int log2_cell) {
  const std::array<std::int64_t, 3> n{std::clamp(nx, 1, 1024), std::clamp(ny, 1, 1024), std::clamp(nz, 1, 1024)};
  const double half = 0.5 / static_cast<double>(1 << std::clamp(log2_cell, 0, 12));
  mesh out;
  std::unordered_map<std::int64_t, std::uint32_t> seen;
  const auto vertex = [&](const std::array<std::int64_t, 3> &p) {
    const auto [at, fresh] =
        seen.try_emplace((p[0] * 2048 + p[1]) * 2048 + p[2], static_cast<std::uint32_t>(out.vertices()));
    if (fresh)
      for (std::size_t k = 0; k < 3; ++k)
        out.xyz.push_back(static_cast<float>(static_cast<double>(2 * p[k] - n[k]) * half));
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far_side : {false, true}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::int64_t i = 0; i < n[u]; ++i)
        for (std::int64_t j = 0; j < n[v]; ++j) {
          std::array<std::int64_t, 3> p{};
          p[axis] = far_side ? n[axis] : 0;
          const auto corner = [&](std::int64_t di, std::int64_t dj) {
            p[u] = i + di;
            p[v] = j + dj;
            return vertex(p);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (far_side)
            out.index.insert(out.index.end(), {a, b, c, a, c, d});
          else
            out.index.insert(out.index.end(), {a, c, b, a, d, c});
        }
    }
  return out;
}

std::vector<float> sphere_cloud(std::size_t n, std::uint64_t seed, double r_min, double r_max) {
  generator g{seed};
  std::vector<float> rows;
  rows.reserve(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      rows.push_back(round16(g.signed_unit()));
    rows.push_back(std::max(0x1p-16f, round16(r_min + (r_max - r_min) * g.unit())));
  }
  return rows;
}

std::vector<float> segment_cloud(std::size_t n, std::uint64_t seed, double length) {
  generator g{seed};
  std::vector<float> rows;
  rows.reserve(6 * n);
  for (std::size_t i = 0; i < n; ++i) {
    vec p{}, d{};
    p.x = g.signed_unit();
    p.y = g.signed_unit();
    p.z = g.signed_unit();
    do { // rejection makes it uniform in the ball, hence in direction
      d.x = g.signed_unit();
      d.y = g.signed_unit();
      d.z = g.signed_unit();
    } while (dot(d, d) > 1 || dot(d, d) < 0x1p-20);
    d = (length / 2) * normal(d);
    for (const vec &q : {p - d, p + d})
      rows.insert(rows.end(), {round16(q.x), round16(q.y), round16(q.z)});
  }
  return rows;
}

} // namespace meetc::bodies
