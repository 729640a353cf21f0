// The plane of a polygon of float32 corners: the axis of its projection, the turns of its corners there, and their
// distance from the plane through the first one. Signs are exact: in double with a bound, else by exact_sum.hpp.
#ifndef MEETC_IO_POLYGON_PLANE_HPP
#define MEETC_IO_POLYGON_PLANE_HPP

#include "meet/io/polygon/exact_sum.hpp"

#include <cstddef>
#include <span>

namespace meetc::io {

// A corner after projection along an axis.
struct projected {
  double x, y; // float32 numbers
};

// The sign of twice the area of a, b, c: 1 if they turn left.
int turn(const projected &a, const projected &b, const projected &c, exact_sum &room);

// Newell's normal, the sum of the cross products of consecutive corners: twice the polygon's area vector.
class polygon_plane {
public:
  // `corners`: 3 floats each.
  explicit polygon_plane(std::span<const float> corners);

  // The axis along which the normal is largest, the least of several; -1 if the normal is zero. Exact.
  int axis() const { return axis_; }
  // The sign of the normal's largest component.
  int side() const { return side_; }
  // The largest distance of a corner from the plane through the first corner, rounded; 0 only if they are all on it, or
  // if the normal is zero.
  double distance() const;

private:
  std::size_t size() const { return corners_.size() / 3; }
  double at(std::size_t corner, int k) const {
    return static_cast<double>(corners_[3 * (corner % size()) + static_cast<std::size_t>(k)]);
  }
  double from_first(std::size_t corner, int k) const { return at(corner, k) - at(0, k); }
  exact_sum component(int k) const;
  void find_axis();

  std::span<const float> corners_;
  double normal_[3], error_[3]; // the normal is within the error
  int axis_ = -1, side_ = 0;
};

} // namespace meetc::io

#endif
