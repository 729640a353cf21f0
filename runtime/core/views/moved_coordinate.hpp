// core/views/moved_coordinate.hpp: the one definition of a pose's arithmetic on a host.
//
// A point becomes ((m0*x + m1*y) + m2*z) + m3 in fp64, in this order, without fma; a caller that stores float32 rounds
// the result once. The CUDA kernels do the same with intrinsics that no compiler may fuse.
#ifndef MEETC_CORE_VIEWS_MOVED_COORDINATE_HPP
#define MEETC_CORE_VIEWS_MOVED_COORDINATE_HPP

namespace meetc {

// One coordinate, by one row of a 3x4 matrix, under the standard control word. The project's flags prevent contraction to fma.
inline double moved_coordinate(const double row[4], double x, double y, double z) {
  return ((row[0] * x + row[1] * y) + row[2] * z) + row[3];
}

} // namespace meetc

#endif
