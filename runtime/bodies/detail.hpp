// Small vectors and reproducible arithmetic for the built-in meshes. It uses only + - * / and sqrt, which IEEE 754
// rounds the same everywhere.
#ifndef MEETC_BODIES_DETAIL_HPP
#define MEETC_BODIES_DETAIL_HPP

#include "meet/bodies/mesh.hpp"
#include "meet/core/views/vec.hpp"

#include <cmath>

namespace meetc::bodies::detail {

// Rounds to the nearest multiple of 2^-16, halves upwards.
inline float round16(double v) {
  return static_cast<float>(std::floor(v * 65536 + 0.5) / 65536);
}
inline void put(mesh &m, const vec &p) {
  m.xyz.insert(m.xyz.end(), {round16(p.x), round16(p.y), round16(p.z)});
}

// Cosine and sine of k / n of a full turn, reduced exactly in integers to an eighth and then computed by series.
// Quarter turns are therefore exact, and mirrored angles give mirrored points. The error is below 1e-15.
struct circle_point {
  double cosine, sine;
};
inline circle_point turn(std::int64_t k, std::int64_t n) {
  std::int64_t e = 8 * (((k % n) + n) % n);    // eighths of a turn, times n
  const auto octant = static_cast<int>(e / n); // 0..7
  e -= n * octant;                             // 0..n-1
  const bool mirrored = octant % 2 != 0;       // the angle is measured from the nearer axis
  const double eighths = static_cast<double>(mirrored ? n - e : e) / static_cast<double>(n);
  const double x = eighths * 0.78539816339744830962, y = x * x;
  double c = 0, s = 0;
  for (int i = 18; i >= 2; i -= 2) { // Horner's rule, from the highest power
    c = 1 - y / (i * (i - 1)) * (i == 18 ? 1 : c);
    s = 1 - y / (i * (i + 1)) * (i == 18 ? 1 : s);
  }
  s *= x;
  const circle_point p = mirrored ? circle_point{s, c} : circle_point{c, s};
  switch (octant / 2) {
  case 0:
    return p;
  case 1:
    return {-p.sine, p.cosine};
  case 2:
    return {-p.cosine, -p.sine};
  default:
    return {p.sine, -p.cosine};
  }
}

} // namespace meetc::bodies::detail

#endif
