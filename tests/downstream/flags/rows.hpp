// Rows that are hard to decide: batches of inputs near zero, at many scales.
#pragma once
#include <meetc/support.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

inline std::mt19937_64 engine(7);
inline int any(int low, int high) {
  return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
}
inline float nudged(float x) {
  const int steps = any(-1, 1);
  return steps > 0 ? meetc::step_up(x) : steps < 0 ? meetc::step_down(x) : x;
}

// n pairs of rows: all points of both operands in one plane or line of a grid, or equal, or a tangent pair of
// spheres; some numbers then moved to a neighbour; at many scales, subnormal numbers and numbers whose
// products overflow among them. No arithmetic of this function decides what is right.
inline void make_rows(int inputs_a, int inputs_b, std::size_t n, std::vector<float> &a, std::vector<float> &b) {
  const int inputs = inputs_a + inputs_b;
  for (std::size_t k = 0; k < n; ++k) {
    float row[32];
    const int family = any(0, 5);
    float origin[3], u[3], v[3];
    for (int i = 0; i < 3; ++i) {
      origin[i] = static_cast<float>(any(-0xfffff, 0xfffff)) * (family == 1 ? 0x1p-20F : 1);
      u[i] = static_cast<float>(any(-4096, 4096)) + (family == 2 ? 0.1F : 0);
      v[i] = static_cast<float>(any(-4096, 4096)) * (family == 2 ? 0.3F : 1);
    }
    float s = 0, t = 0;
    for (int i = 0; i < inputs; ++i) {
      // Points begin at multiples of 3; spheres (4 numbers) put a radius there, which does no harm.
      if (i % 3 == 0) {
        s = static_cast<float>(any(-16, 16)) / 16;
        t = family == 3 ? 0 : static_cast<float>(any(-16, 16)) / 16;
      }
      row[i] = origin[i % 3] + s * u[i % 3] + t * v[i % 3];
      if (family == 4 && i >= 3 && any(0, 1))
        row[i] = row[i - 3];
      if (any(0, 7) == 0)
        row[i] = nudged(row[i]);
      if (family == 5) // a small box round zero, for numbers far above one
        row[i] = static_cast<float>(any(-1, 1));
    }
    if (inputs_a == 4) { // a sphere that touches, or nearly: a multiple of a Pythagorean triple away
      const float step = static_cast<float>(any(1, 1 << 18));
      row[0] = row[4] + 3 * step, row[1] = row[5] + 4 * step, row[2] = row[6] + (any(0, 1) ? 12 * step : 0);
      row[3] = static_cast<float>(any(0, 13)) * step;
      if (inputs_b == 4)
        row[7] = static_cast<float>(any(0, 13)) * step;
      row[3] = std::fabs(nudged(row[3]));
    }
    const int scales[] = {0, 0, 0, -40, 20, -140, -110, 103, 80};
    const int scale = scales[any(0, 8)];
    for (int i = 0; i < inputs; ++i)
      row[i] = std::ldexp(row[i], scale);
    a.insert(a.end(), row, row + inputs_a);
    b.insert(b.end(), row + inputs_a, row + inputs);
  }
}
