// Poses that tests draw.
#pragma once
#include "meet/core/views/pose.hpp"

#include <array>
#include <cmath>
#include <random>

namespace world_test {

inline double uniform(std::mt19937 &g, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(g()) * 0x1p-32);
}

// A rotation by a unit quaternion, a scale, and a move by at most `range`.
inline meetc::pose drawn(std::mt19937 &g, double range, double scale = 1) {
  std::array<double, 4> q{};
  double n = 0;
  for (double &x : q)
    x = uniform(g, -1, 1), n += x * x;
  for (double &x : q)
    x /= std::sqrt(n);
  const auto [w, x, y, z] = q;
  meetc::pose p;
  const double m[12] = {1 - 2 * (y * y + z * z),   2 * (x * y - w * z),       2 * (x * z + w * y),
                        uniform(g, -range, range), 2 * (x * y + w * z),       1 - 2 * (x * x + z * z),
                        2 * (y * z - w * x),       uniform(g, -range, range), 2 * (x * z - w * y),
                        2 * (y * z + w * x),       1 - 2 * (x * x + y * y),   uniform(g, -range, range)};
  for (int i = 0; i < 12; ++i)
    p.m[i] = i % 4 == 3 ? m[i] : m[i] * scale;
  p.length_scale = scale;
  return p;
}

} // namespace world_test
