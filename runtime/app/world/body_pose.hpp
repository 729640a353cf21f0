// app/world/body_pose.hpp: the pose of a body from the numbers that a user writes.
#ifndef MEETC_APP_WORLD_BODY_POSE_HPP
#define MEETC_APP_WORLD_BODY_POSE_HPP

#include "meet/core/views/pose.hpp"

#include <span>
#include <string>

namespace meetc::app {

// 12 numbers are a row-major 3x4 matrix, 16 one of 4x4 whose last row is 0 0 0 1, and 7 a position and a quaternion w x y z,
// which is normalised in double and whose matrix is the pose. A matrix must be a similarity (io::similarity_scale), so that
// every kind can stand in it, as good a one as float32 has. Throws failure, which begins with `where`.
pose pose_of(std::span<const double> numbers, const std::string &where);

} // namespace meetc::app

#endif
