// app/input/motor.hpp: a motor as a pose.
#ifndef MEETC_APP_INPUT_MOTOR_HPP
#define MEETC_APP_INPUT_MOTOR_HPP

#include "meetc/number/motion.hpp"

#include <algorithm>
#include <array>

namespace meetc::app {

// The motion of a motor of pga3_planes.toml as a matrix, row by row: its numbers are those on 1, e23, e31, e12, e01, e02, e03
// and e0123, at any scale. Where the first four are 0 it is no motion, and the matrix NaN. The values are those of the
// function pose(motor) that is emitted for that algebra, bit for bit (tests/generated/analytic).
inline std::array<double, 12> matrix_of_motor(const std::array<double, 8> &v) {
  double m[12];
  motions::pose<double>({v[0], {-v[1], -v[2], -v[3]}, -v[7], {-v[4], -v[5], -v[6]}}, 2.0, m);
  std::array<double, 12> out{};
  std::copy_n(m, 12, out.begin());
  return out;
}

} // namespace meetc::app

#endif
