// The cube in which a filter of every pair evaluates its form. It is made from one set; each element of both sets has a
// place relative to it.
//
// Every thread widens one interval for each axis by its elements, intervals are joined, and the bits of their ends are
// joined across the device by integer minima and maxima. There is one copy of this arithmetic, which kernels call as
// well as their stand-in on a host.
//
// The invariant: an element is called `inside` or `apart` only where comparisons of finite numbers prove it. No
// comparison with NaN holds, so an element with unknown numbers, or one that the frame was not made for, meets
// everything. In particular, an element whose box overflows float32 is left out of its own set's frame, which stays
// that of the others, and is `everywhere`.
#ifndef MEETC_EVERY_PAIR_FRAME_HPP
#define MEETC_EVERY_PAIR_FRAME_HPP

#include <meetc/every_pair/enclosing.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

MEETC_NAMESPACE(meetc) {

// ---- the extent of a set ----

// Maps doubles to bits whose integer order is that of the numbers, and back.
MEETC_HD inline unsigned long long ordered(double x) {
  std::uint64_t b;
  std::memcpy(&b, &x, sizeof b);
  return b >> 63 ? ~b : b | std::uint64_t{1} << 63;
}
MEETC_HD inline double from_ordered(unsigned long long bits) {
  std::uint64_t b = bits;
  b = b >> 63 ? b & ~(std::uint64_t{1} << 63) : ~b;
  double x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}

// Empty by default.
struct interval {
  double lo = HUGE_VAL, hi = -HUGE_VAL;
};
MEETC_HD inline interval joined(const interval &x, const interval &y) {
  return {std::fmin(x.lo, y.lo), std::fmax(x.hi, y.hi)};
}

// Widens the intervals of the three axes by the ball around an element's box, where that is finite.
template <class Shape> MEETC_HD inline void widen(interval around[3], const float *row) {
  if (!has_finite_box<Shape>(row))
    return; // place_element() calls it everywhere
  double ball[4];
  ball_of_box<Shape>(row, ball);
  for (int k = 0; k < 3; ++k)
    around[k] = joined(around[k], {ball[k] - ball[3], ball[k] + ball[3]});
}

// The same for a whole set. The ends are stored as bits in the order of the numbers, so that integer minima and maxima
// join them.
struct extent {
  unsigned long long low[3], high[3];
};
MEETC_HD inline void clear(extent &e, int axis) {
  e.low[axis] = ordered(interval().lo), e.high[axis] = ordered(interval().hi);
}

// ---- the frame ----

// Coordinates are moved by -origin and multiplied by scale, a power of two, so that they lie in [-2^11, 2^11].
struct matrix_frame {
  double origin[3], scale;
};
inline constexpr double matrix_reach = 2048;

// The frame of a set by its intervals. They are empty if no element has a finite box. All elements are then
// `everywhere`, and any frame will do.
MEETC_HD inline matrix_frame frame_of(const interval around[3]) {
  matrix_frame f{{0, 0, 0}, 1};
  bool known = true;
  for (int k = 0; k < 3; ++k)
    known &= is_finite(around[k].lo) & is_finite(around[k].hi);
  if (!known)
    return f;
  double half = 0;
  for (int k = 0; k < 3; ++k) {
    f.origin[k] = around[k].lo / 2 + around[k].hi / 2;
    const double h = around[k].hi / 2 - around[k].lo / 2;
    half = h > half ? h : half;
  }
  if (!(half > 0))
    return f;
  std::uint64_t b;
  std::memcpy(&b, &half, sizeof b);
  const int e = static_cast<int>(b >> 52) - 1022;      // half < 2^e
  b = static_cast<std::uint64_t>(1023 + 11 - e) << 52; // float32 gives halves from 2^-150 to 2^130
  std::memcpy(&f.scale, &b, sizeof f.scale);
  return f;
}
MEETC_HD inline matrix_frame frame_of(const extent &e) {
  interval around[3];
  for (int k = 0; k < 3; ++k)
    around[k] = {from_ordered(e.low[k]), from_ordered(e.high[k])};
  return frame_of(around);
}

// Where an element lies. The cube holds all elements of the set that the frame was made from, except those that are
// `everywhere`. An element that does not reach the cube therefore touches none of the others.
enum class placing : std::uint8_t {
  inside,     // within reach in every number; the filter's bound is proved only for such balls
  apart,      // does not reach the cube: meets only what is everywhere
  astride,    // none of the others is proved: meets everything that is not apart
  everywhere, // some number is not finite, so the frame was not made for it: meets everything
  nowhere,    // not an element, but padding behind the last: meets nothing
};
// Transforms the ball x, y, z, r into the frame.
MEETC_HD inline placing place_ball(const matrix_frame &frame, double ball[4]) {
  bool inside = true, finite = true, apart = false;
  for (int k = 0; k < 4; ++k) {
    ball[k] = (k < 3 ? ball[k] - frame.origin[k] : ball[k]) * frame.scale;
    inside &= std::fabs(ball[k]) <= matrix_reach;
    finite &= is_finite(ball[k]);
  }
  // The slack far exceeds the rounding errors of these lines.
  for (int k = 0; k < 3; ++k)
    apart |= std::fabs(ball[k]) - ball[3] > matrix_reach + 1 + 1e-9 * (std::fabs(ball[k]) + ball[3]);
  return inside ? placing::inside : !finite ? placing::everywhere : apart ? placing::apart : placing::astride;
}

// The element as a ball in the frame. There is no ball where it is `everywhere`.
template <class Shape>
MEETC_HD inline placing place_element(const matrix_frame &frame, cover c, const float *row, double ball[4]) {
  if (!has_finite_box<Shape>(row))
    return placing::everywhere;
  ball_around<Shape>(c, row, ball);
  return place_ball(frame, ball);
}

} // MEETC_NAMESPACE(meetc)

#endif
