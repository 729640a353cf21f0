// A ball around any bounded element, which is the hull of a few points, widened by a radius.
//
// A Shape describes the rows of a kind: fields, hull (the number of points), coordinate() and pad (the places of the
// points and of the radius), and box(), the closed box of an element.
#ifndef MEETC_EVERY_PAIR_ENCLOSING_HPP
#define MEETC_EVERY_PAIR_ENCLOSING_HPP

#include <meetc/environment/environment.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

MEETC_NAMESPACE(meetc) {

template <class Shape> MEETC_HD inline double hull_point(const float *row, int point, int axis) {
  const int at = Shape::coordinate(point, axis);
  return at < 0 ? 0 : static_cast<double>(row[at]);
}

// A ball x, y, z, r that holds the element, in fp64. r is rounded up by more than its possible error. The centre starts
// in the middle of the hull's box and moves towards the farthest point (Badoiu and Clarkson, "Smaller core-sets for
// balls", 2003); the ball holds the element wherever the centre ends.
template <class Shape> MEETC_HD inline void enclosing_ball(const float *row, double ball[4]) {
  for (int k = 0; k < 3; ++k) {
    double lo = hull_point<Shape>(row, 0, k), hi = lo;
    for (int p = 1; p < Shape::hull; ++p) {
      const double v = hull_point<Shape>(row, p, k);
      lo = v < lo ? v : lo, hi = hi < v ? v : hi;
    }
    ball[k] = lo / 2 + hi / 2;
  }
  double farthest = 0;
  constexpr int steps = Shape::hull > 2 ? 8 : 0;
  for (int step = 0; step <= steps; ++step) {
    int which = 0;
    farthest = 0;
    for (int p = 0; p < Shape::hull; ++p) {
      double d = 0;
      for (int k = 0; k < 3; ++k) {
        const double x = hull_point<Shape>(row, p, k) - ball[k];
        d += x * x;
      }
      which = d > farthest ? p : which;
      farthest = d > farthest ? d : farthest;
    }
    if (step < steps)
      for (int k = 0; k < 3; ++k)
        ball[k] += (hull_point<Shape>(row, which, k) - ball[k]) * (1.0 / (step + 2));
  }
  ball[3] = std::sqrt(farthest) * (1 + 0x1p-48);
  if constexpr (Shape::pad >= 0)
    ball[3] = (ball[3] + static_cast<double>(row[Shape::pad])) * (1 + 0x1p-50);
}

// The content of a ball: the element alone, or its box as well.
enum class cover : std::uint8_t { element, box };

// False for NaN.
MEETC_HD inline bool is_finite(float x) {
  return std::fabs(x) < HUGE_VALF;
}
MEETC_HD inline bool is_finite(double x) {
  return std::fabs(x) < HUGE_VAL;
}

// Whether the element's box is finite. A box that is rounded outwards can exceed float32 although the element's own numbers do
// not. Such an element gets no ball and takes no part in a frame.
template <class Shape> MEETC_HD inline bool has_finite_box(const float *row) {
  float lo[3], hi[3];
  Shape::box(row, lo, hi);
  bool finite = true;
  for (int k = 0; k < 3; ++k)
    finite &= is_finite(lo[k]) & is_finite(hi[k]);
  return finite;
}

// A ball that holds the element's box, which must be finite.
template <class Shape> MEETC_HD inline void ball_of_box(const float *row, double ball[4]) {
  float lo[3], hi[3];
  Shape::box(row, lo, hi);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double l = static_cast<double>(lo[k]), h = static_cast<double>(hi[k]);
    ball[k] = l / 2 + h / 2;
    const double half = h / 2 - l / 2;
    square += half * half;
  }
  ball[3] = std::sqrt(square) * (1 + 0x1p-48);
}

// A ball around what `c` names. The element's box must be finite.
template <class Shape> MEETC_HD inline void ball_around(cover c, const float *row, double ball[4]) {
  if (c == cover::box)
    ball_of_box<Shape>(row, ball);
  else
    enclosing_ball<Shape>(row, ball);
}

} // MEETC_NAMESPACE(meetc)

#endif
