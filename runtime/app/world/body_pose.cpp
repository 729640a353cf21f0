#include "meet/app/world/body_pose.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/matrix.hpp"
#include "meet/io/elements/transform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace meetc::app {

namespace {

// A position and a quaternion, which is divided by its length, and by its largest number first, so that nothing overflows.
std::array<double, 12> matrix_of_quaternion(std::span<const double> v, const std::string &where) {
  const double largest = std::max({std::abs(v[3]), std::abs(v[4]), std::abs(v[5]), std::abs(v[6])});
  if (!(largest > 0))
    throw failure(fmt::format("{}: the quaternion is 0, so this is no rotation", where));
  const double a = v[3] / largest, b = v[4] / largest, c = v[5] / largest, d = v[6] / largest;
  const double length = std::sqrt(((a * a + b * b) + c * c) + d * d);
  const double w = a / length, x = b / length, y = c / length, z = d / length;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),     v[0],
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),     v[1],
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y), v[2]};
}

} // namespace

pose pose_of(std::span<const double> numbers, const std::string &where) {
  if (numbers.size() != 7 && numbers.size() != 12 && numbers.size() != 16)
    throw failure(
        fmt::format("{}: {} numbers; a pose is a 3x4 or 4x4 matrix, or a position and a quaternion x,y,z,qw,qx,qy,qz",
                    where, numbers.size()));
  if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
    throw failure(fmt::format("{}: a number of the pose is not finite", where));
  pose p;
  const std::array<double, 12> m =
      numbers.size() == 7 ? matrix_of_quaternion(numbers, where) : matrix_of(numbers, where);
  std::copy_n(m.begin(), 12, p.m);
  const std::optional<double> scale = io::similarity_scale(m, io::similarity_slack_float32);
  if (!scale || !(*scale > 0))
    throw failure(fmt::format("{}: the matrix is no rotation with one scale, so this is no motion", where));
  p.length_scale = *scale;
  return p;
}

} // namespace meetc::app
