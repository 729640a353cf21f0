// core/pose.hpp: where a set stands, and the one definition of that arithmetic on a host.
//
// A point becomes ((m0*x + m1*y) + m2*z) + m3 in fp64, in this order, without fma; a caller that stores float32 rounds
// the result once. The CUDA kernels do the same with intrinsics that no compiler may fuse.
#ifndef MEETC_CORE_POSE_HPP
#define MEETC_CORE_POSE_HPP

#include "meetc/support.hpp"

namespace meetc {

// One coordinate, by one row of a 3x4 matrix. The project's flags prevent contraction to fma.
inline double moved_coordinate(const double row[4], double x, double y, double z) {
  return ((row[0] * x + row[1] * y) + row[2] * z) + row[3];
}

// A row-major 3x4 matrix; each coordinate is rounded once to float32. Lengths are multiplied by length_scale, which the
// caller takes from the similarity, in fp64, and are rounded once. In a kind of the plane z counts as 0. The identity
// changes no bit.
struct pose {
  double m[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  double length_scale = 1;

  bool identity() const;
};

// Whether a pose can move every field of the kind: all are points x, y, z (or x, y) in this order, or lengths.
bool can_move(const kind_info &kind);

// Moves one row of kind.fields floats in place. The kind must pass can_move(). The result may be infinite or NaN.
void move_row(const kind_info &kind, const pose &at, float *row);

} // namespace meetc

#endif
