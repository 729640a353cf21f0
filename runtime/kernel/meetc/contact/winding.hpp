// The winding number of a surface of triangles at a point: how often it goes around the point, 1 inside a closed surface whose
// normals point outwards. It is the sum over the triangles that a ray along z meets on its way upwards, 1 for each that it
// leaves by and -1 for each that it enters by.
//
// A ray may pass through corners, along edges and in the plane of a triangle. The point is therefore taken as p + e x + e^2 y
// for an e that is as small as one likes: near a point that lies on no triangle the number is the same. A turn that is 0 at p
// is then a comparison of two coordinates, and no point is computed.
#ifndef MEETC_CONTACT_WINDING_HPP
#define MEETC_CONTACT_WINDING_HPP

#include <meetc/contact/signs.hpp>

#include <cstddef>

MEETC_NAMESPACE(meetc) {

template <class Side> struct winding_signs {
  // The turn of x, y and the point seen from above, never 0 unless y lies above x.
  MEETC_HD static int turn(const float *x, const float *y, const float *p) {
    if (const int exact = contact_signs<exact_sides<Side>>().turn(2, x, y, p); exact != 0)
      return exact;
    if (x[1] != y[1])
      return x[1] > y[1] ? 1 : -1;
    return y[0] > x[0] ? 1 : y[0] < x[0] ? -1 : 0;
  }
  // The part of one triangle, which does not hold the point.
  MEETC_HD static int part(const float *p, const float *triangle) {
    const float *const a = triangle, *const b = triangle + 3, *const c = triangle + 6;
    const int side = turn(a, b, p); // the three are equal where the ray's line meets the triangle
    if (side == 0 || turn(b, c, p) != side || turn(c, a, p) != side)
      return 0;
    return contact_signs<exact_sides<Side>>().side(triangle, p) == -side ? side
                                                                         : 0; // it lies above the point, or below
  }
};

// predicate_info::winding.
template <class Side> int winding_part(const float *point, const float *rows, std::size_t n) {
  int sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += winding_signs<Side>::part(point, rows + std::size_t{9} * i);
  return sum;
}

} // MEETC_NAMESPACE(meetc)

#endif
