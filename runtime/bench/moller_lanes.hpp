// bench/moller_lanes.hpp: Möller's test with epsilon 0, made as fast as one object against many allows.
//
// Problem: a certified test in lanes must be compared with a classic test that has the same advantages.
// Method: each triangle's plane is computed once and stored, as our predicates store theirs. The scalar test then starts
// with dot products. In lanes, lane_count triangles of b, held field by field, meet one triangle of a: the signs of their
// corners relative to its plane, and then, where a lane is left, the signs of its corners relative to theirs. Few lanes
// outlive both, and each of them goes to the scalar rest of the test. A distance is a chain of three fma() where the
// instruction set has one, and of products and sums elsewhere, alike in the scalar test and in lanes, so both give the
// same answers. These may differ from those of baselines::moller(), whose distances are rounded otherwise.
// Limits: those of Möller's test in float.
#ifndef MEETC_BENCH_MOLLER_LANES_HPP
#define MEETC_BENCH_MOLLER_LANES_HPP

#include "bench/baseline_moller.hpp"
#include "bench/classic_tests.hpp"

#include <meetc/lanes.hpp>

MEETC_NAMESPACE(meetc::baselines) {

// a b + c, rounded as lanes round it.
MEETC_INLINE float multiply_add(float a, float b, float c) {
#if MEETC_FUSES
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}
MEETC_INLINE lanes multiply_add(lanes a, lanes b, lanes c) {
  return fma(a, b, c);
}

// The signed distance of a point to a plane, multiplied by the length of its normal.
template <class T> MEETC_INLINE T distance_to(const T plane[4], T x, T y, T z) {
  return multiply_add(plane[0], x, multiply_add(plane[1], y, multiply_add(plane[2], z, plane[3])));
}
MEETC_INLINE detail::distances<float> distances_to(const float plane[4], const float *t) {
  return {distance_to(plane, t[0], t[1], t[2]), distance_to(plane, t[3], t[4], t[5]),
          distance_to(plane, t[6], t[7], t[8])};
}

// Row i of a against row j of b.
MEETC_INLINE bool moller_stored(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t j) {
  const float *const row_a = a.rows + 9 * i, *const row_b = b.rows + 9 * j;
  const float *const plane_a = a.planes + 4 * i, *const plane_b = b.planes + 4 * j;
  const detail::distances<float> db = distances_to(plane_a, row_b);
  if (db.one_side())
    return false;
  const detail::distances<float> da = distances_to(plane_b, row_a);
  if (da.one_side())
    return false;
  return moller_beyond_planes(row_a, {plane_a[0], plane_a[1], plane_a[2]}, da, row_b,
                              {plane_b[0], plane_b[1], plane_b[2]}, db);
}

// The lanes in which the corners of a triangle lie on one side of a plane, by products as in distances::one_side().
MEETC_INLINE lane_mask one_side_lanes(lanes d0, lanes d1, lanes d2) {
  const lanes zero(0.0F);
  return greater(d0 * d1, zero) & greater(d0 * d2, zero);
}

// Row i of a against lane_count rows of b from j on; a bit for each that touches.
MEETC_INLINE lane_mask moller_lanes(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t j) {
  const auto column = [&b, j](std::size_t field) { return lanes::from(b.columns + field * b.stride + j); };
  lanes plane[4];
  for (std::size_t k = 0; k < 4; ++k)
    plane[k] = lanes(a.planes[4 * i + k]);
  lanes d[3];
  for (std::size_t p = 0; p < 3; ++p)
    d[p] = distance_to(plane, column(3 * p), column(3 * p + 1), column(3 * p + 2));
  lane_mask left = every_lane & ~one_side_lanes(d[0], d[1], d[2]);
  if (left == 0)
    return 0;
  const float *const row = a.rows + 9 * i;
  for (std::size_t k = 0; k < 4; ++k)
    plane[k] = column(9 + k);
  for (std::size_t p = 0; p < 3; ++p)
    d[p] = distance_to(plane, lanes(row[3 * p]), lanes(row[3 * p + 1]), lanes(row[3 * p + 2]));
  left &= ~one_side_lanes(d[0], d[1], d[2]);
  lane_mask hits = 0;
  for (; left != 0; left &= left - 1) {
    const int k = __builtin_ctz(left);
    hits |= lane_mask{moller_stored(a, i, b, j + static_cast<std::size_t>(k))} << k;
  }
  return hits;
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
