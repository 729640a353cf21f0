// Implicit bodies: a smooth union of rounded cones, meshed by marching tetrahedra on a lattice whose cubes are cut into
// six (Kuhn), so that neighbouring cubes agree and the result is a manifold without special cases.
//
// The vertices are then moved a few times to the middle of their neighbours and back onto the surface, which removes
// the slivers that marching leaves. Limits: the body must be thicker than a lattice cell.
#include "meet/bodies/detail.hpp"
#include "meet/bodies/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>

namespace meetc::bodies {
namespace {

using namespace detail;

struct cone { // the union of the balls of radius r + t (s - r) about a + t (b - a), 0 <= t <= 1
  vec a, b;
  double r, s;
  double blend; // width of the blend with the cones before it
};

struct body {
  std::span<const cone> parts;
  vec low, high;
  double ribs; // depth of the ribs on the back
};

// The signed distance to a rounded cone, which is that to its end balls or to the cone tangent to both. It is computed
// in the plane of p and the axis, scaled by the length l of the axis: y along it, x across.
double distance(const cone &c, const vec &p) {
  const vec axis = c.b - c.a, q = p - c.a;
  const double l2 = dot(axis, axis), slope = c.r - c.s, side2 = l2 - slope * slope;
  if (!(side2 > 0)) // one ball contains the other
    return c.r >= c.s ? root(dot(q, q)) - c.r : root(dot(p - c.b, p - c.b)) - c.s;
  const double y = dot(q, axis), z = y - l2;
  const vec off = l2 * q - y * axis;
  const double x2 = dot(off, off), y2 = y * y * l2, z2 = z * z * l2, k = std::abs(slope) * slope * x2;
  if (std::copysign(side2 * z2, z) > k)
    return root(x2 + z2) / l2 - c.s;
  if (std::copysign(side2 * y2, y) < k)
    return root(x2 + y2) / l2 - c.r;
  return (root(x2 * side2 / l2) + y * slope) / l2 - c.r;
}

double field(const body &shape, const vec &p) {
  double f = 4;
  for (const cone &c : shape.parts) {
    const double g = distance(c, p);
    const double h = std::max(c.blend - std::abs(f - g), 0.0) / c.blend; // a smooth minimum
    f = std::min(f, g) - h * h * c.blend / 4;
  }
  if (shape.ribs > 0 && p.z < 0) { // a smooth wave along y, which fades in behind z = 0
    const double w = p.y * 8 - std::floor(p.y * 8), wave = 16 * w * w * (1 - w) * (1 - w);
    f += shape.ribs * wave * std::min(1.0, -4 * p.z);
  }
  return f;
}

vec onto_surface(const body &shape, vec p, double step) {
  for (int i = 0; i < 2; ++i) {
    const vec g{field(shape, p + vec{step, 0, 0}) - field(shape, p - vec{step, 0, 0}),
                field(shape, p + vec{0, step, 0}) - field(shape, p - vec{0, step, 0}),
                field(shape, p + vec{0, 0, step}) - field(shape, p - vec{0, 0, step})};
    const double size = dot(g, g);
    if (size > step * step) // slope above one half
      p = p - (2 * step * std::clamp(field(shape, p), -step, step) / size) * g;
  }
  return p;
}

// Vertices and triangles as marching leaves them, in double.
struct raw_mesh {
  std::vector<vec> at;
  std::vector<std::uint32_t> index;
};

raw_mesh march(const body &shape, double cell) {
  const vec size = shape.high - shape.low;
  const auto cells = [&](double v) { return static_cast<std::size_t>(std::ceil(v / cell)) + 1; };
  const std::size_t nx = cells(size.x), ny = cells(size.y), nz = cells(size.z);
  const std::array<std::size_t, 8> offset{0, 1, nx, 1 + nx, nx * ny, 1 + nx * ny, nx + nx * ny, 1 + nx + nx * ny};
  const auto place = [&](std::size_t v) {
    const std::size_t x = v % nx, y = v / nx % ny, z = v / nx / ny;
    return shape.low + cell * vec{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  std::vector<double> value(nx * ny * nz);
  for (std::size_t v = 0; v < value.size(); ++v)
    value[v] = field(shape, place(v));

  raw_mesh out;
  std::unordered_map<std::uint64_t, std::uint32_t> cuts;
  const auto cut = [&](std::size_t in, std::size_t outside) { // the vertex on a lattice edge
    const std::size_t a = std::min(in, outside), b = std::max(in, outside);
    const auto way = static_cast<std::size_t>(std::find(offset.begin(), offset.end(), b - a) - offset.begin());
    const auto [at, fresh] = cuts.try_emplace(a * 8 + way, static_cast<std::uint32_t>(out.at.size()));
    if (fresh) {
      const double t = std::clamp(value[a] / (value[a] - value[b]), 0.1, 0.9);
      out.at.push_back(place(a) + t * (place(b) - place(a)));
    }
    return at->second;
  };
  // They surround the diagonal from corner 0 to corner 7, and all are right-handed.
  constexpr std::array<std::array<std::size_t, 4>, 6> tetrahedra{
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  for (std::size_t z = 0; z + 1 < nz; ++z)
    for (std::size_t y = 0; y + 1 < ny; ++y)
      for (std::size_t x = 0; x + 1 < nx; ++x) {
        const std::size_t base = x + nx * (y + ny * z);
        unsigned inside = 0;
        for (std::size_t i = 0; i < 8; ++i)
          inside |= static_cast<unsigned>(value[base + offset[i]] < 0) << i;
        if (inside == 0 || inside == 255)
          continue;
        for (const auto &tetrahedron : tetrahedra) {
          std::array<std::size_t, 4> v = tetrahedron; // inside corners first, keeping the orientation
          int n = 0;
          bool odd = false;
          for (std::size_t i = 0; i < 4; ++i)
            if (inside >> tetrahedron[i] & 1u) {
              for (std::size_t j = i; j > static_cast<std::size_t>(n); --j) {
                std::swap(v[j], v[j - 1]);
                odd = !odd;
              }
              ++n;
            }
          for (std::size_t &corner : v)
            corner = base + offset[corner];
          // The arguments are in braces, so that new vertices are numbered in the order written with every compiler.
          const auto triangle = [&](std::array<std::uint32_t, 3> t) {
            if (odd)
              std::swap(t[1], t[2]);
            out.index.insert(out.index.end(), t.begin(), t.end());
          };
          if (n == 1) {
            triangle({cut(v[0], v[1]), cut(v[0], v[2]), cut(v[0], v[3])});
          } else if (n == 3) {
            triangle({cut(v[0], v[3]), cut(v[1], v[3]), cut(v[2], v[3])});
          } else if (n == 2) {
            const std::uint32_t a = cut(v[0], v[2]), b = cut(v[0], v[3]), c = cut(v[1], v[3]), d = cut(v[1], v[2]);
            triangle({a, b, c});
            triangle({a, c, d});
          }
        }
      }
  return out;
}

mesh realise(const body &shape, int resolution) {
  const double cell = (shape.high.y - shape.low.y) / std::clamp(resolution, 48, 320);
  raw_mesh raw = march(shape, cell);
  std::vector<vec> sum(raw.at.size());
  std::vector<int> count(raw.at.size());
  for (int round = 0; round < 4; ++round) {
    std::fill(sum.begin(), sum.end(), vec{});
    std::fill(count.begin(), count.end(), 0);
    for (std::size_t i = 0; i < raw.index.size(); ++i) {
      const std::uint32_t a = raw.index[i], b = raw.index[i % 3 == 2 ? i - 2 : i + 1];
      sum[a] = sum[a] + raw.at[b]; // each edge comes once in each direction, so every neighbour counts once
      ++count[a];
    }
    for (std::size_t v = 0; v < raw.at.size(); ++v)
      raw.at[v] = onto_surface(shape, 0.5 * raw.at[v] + (0.5 / count[v]) * sum[v], cell / 4);
  }
  mesh out;
  out.index = std::move(raw.index);
  out.xyz.reserve(raw.at.size() * 3);
  for (const vec &p : raw.at)
    put(out, p);
  return out;
}

} // namespace

mesh blob(int resolution) {
  static constexpr std::array<cone, 17> parts{{
      {{0, -0.42, -0.12}, {0, -0.10, -0.02}, 0.47, 0.36, 0.05},   // haunches to chest
      {{0, 0.05, 0.10}, {0, 0.34, 0.22}, 0.26, 0.20, 0.20},       // neck
      {{0, 0.46, 0.24}, {0, 0.38, 0.46}, 0.25, 0.13, 0.12},       // head and muzzle
      {{0.09, 0.36, 0.44}, {0.09, 0.36, 0.45}, 0.10, 0.10, 0.05}, // cheeks
      {{-0.09, 0.36, 0.44}, {-0.09, 0.36, 0.45}, 0.10, 0.10, 0.05},
      {{0.10, 0.62, 0.16}, {0.20, 1.02, 0.02}, 0.085, 0.115, 0.08}, // ears
      {{0.20, 1.02, 0.02}, {0.24, 1.22, -0.10}, 0.115, 0.05, 0.01},
      {{-0.10, 0.62, 0.16}, {-0.22, 1.00, 0.06}, 0.085, 0.115, 0.08},
      {{-0.22, 1.00, 0.06}, {-0.36, 1.14, 0.10}, 0.115, 0.05, 0.01},
      {{0.36, -0.52, 0.02}, {0.36, -0.44, -0.10}, 0.24, 0.28, 0.08}, // thighs
      {{-0.36, -0.52, 0.02}, {-0.36, -0.44, -0.10}, 0.24, 0.28, 0.08},
      {{0.42, -0.80, -0.10}, {0.46, -0.81, 0.42}, 0.12, 0.10, 0.08}, // feet
      {{-0.42, -0.80, -0.10}, {-0.46, -0.81, 0.42}, 0.12, 0.10, 0.08},
      {{0.17, -0.10, 0.22}, {0.15, -0.80, 0.44}, 0.13, 0.085, 0.08}, // forelegs
      {{-0.17, -0.10, 0.22}, {-0.15, -0.80, 0.44}, 0.13, 0.085, 0.08},
      {{0, -0.58, -0.60}, {0, -0.52, -0.66}, 0.16, 0.15, 0.06}, // tail
      {{0, -0.30, -0.20}, {0, -0.12, -0.18}, 0.42, 0.34, 0.10}, // back
  }};
  return realise({parts, {-0.95, -1.05, -1.0}, {0.95, 1.4, 0.85}, 0}, resolution);
}

mesh figure(int resolution) {
  static constexpr std::array<cone, 24> parts{{
      {{0, -0.22, -0.04}, {0, 0.22, -0.06}, 0.32, 0.36, 0.05},       // trunk
      {{0, 0.10, -0.20}, {0, -0.10, -0.22}, 0.30, 0.28, 0.10},       // shell
      {{0, 0.48, 0.06}, {0, 0.64, 0.14}, 0.20, 0.19, 0.15},          // neck
      {{0, 0.70, 0.16}, {0, 0.60, 0.46}, 0.21, 0.085, 0.10},         // head and snout
      {{0.12, 0.84, 0.10}, {0.22, 1.12, -0.02}, 0.085, 0.075, 0.06}, // ears
      {{0.22, 1.12, -0.02}, {0.22, 1.24, -0.08}, 0.075, 0.06, 0.01},
      {{-0.12, 0.84, 0.10}, {-0.22, 1.12, -0.02}, 0.085, 0.075, 0.06},
      {{-0.22, 1.12, -0.02}, {-0.22, 1.24, -0.08}, 0.075, 0.06, 0.01},
      {{0.30, 0.36, 0.0}, {0.66, 0.30, 0.08}, 0.17, 0.135, 0.12}, // right arm, raised
      {{0.66, 0.30, 0.08}, {0.86, 0.66, 0.26}, 0.13, 0.10, 0.05},
      {{0.86, 0.66, 0.26}, {0.90, 0.82, 0.34}, 0.11, 0.10, 0.01},
      {{0.90, 0.84, 0.34}, {0.80, 0.97, 0.42}, 0.07, 0.065, 0.04},
      {{0.92, 0.84, 0.34}, {0.96, 1.00, 0.36}, 0.07, 0.065, 0.04},
      {{-0.30, 0.36, 0.0}, {-0.64, 0.22, 0.12}, 0.17, 0.135, 0.12}, // left arm, stretched forward
      {{-0.64, 0.22, 0.12}, {-0.70, 0.30, 0.56}, 0.13, 0.10, 0.05},
      {{-0.70, 0.30, 0.56}, {-0.70, 0.34, 0.70}, 0.11, 0.09, 0.01},
      {{0.22, -0.44, 0.0}, {0.34, -0.84, 0.10}, 0.22, 0.17, 0.12}, // legs
      {{0.34, -0.84, 0.10}, {0.36, -1.18, 0.0}, 0.165, 0.12, 0.06},
      {{0.36, -1.22, -0.02}, {0.42, -1.24, 0.28}, 0.125, 0.10, 0.06},
      {{-0.22, -0.44, 0.0}, {-0.34, -0.84, 0.12}, 0.22, 0.17, 0.12},
      {{-0.34, -0.84, 0.12}, {-0.36, -1.18, 0.02}, 0.165, 0.12, 0.06},
      {{-0.36, -1.22, 0.0}, {-0.42, -1.24, 0.30}, 0.125, 0.10, 0.06},
      {{0, -0.44, -0.22}, {0.08, -0.86, -0.48}, 0.19, 0.115, 0.10}, // tail
      {{0.08, -0.86, -0.48}, {0.22, -1.10, -0.86}, 0.115, 0.085, 0.06},
  }};
  return realise({parts, {-1.2, -1.5, -1.1}, {1.2, 1.45, 0.95}, 0.03}, resolution);
}

} // namespace meetc::bodies
