// A ball around any bounded element: its hull, a few points, and the radius around that.
//
// A Shape says where a kind's points and its radius lie in a row: fields, hull (the number of points), place(), pad.
#ifndef MEET_ENCLOSING_HPP
#define MEET_ENCLOSING_HPP

#include <meet/environment.hpp>

#include <cmath>

namespace meet {

template <class Shape> MEET_HD inline double hull_point(const float *row, int point, int axis) {
  const int at = Shape::place(point, axis);
  return at < 0 ? 0 : static_cast<double>(row[at]);
}

// A ball x, y, z, r that holds the element, in fp64: r is rounded up, by more than it can be off. The centre starts in
// the middle of the hull's box and walks towards the farthest point (Badoiu and Clarkson, "Smaller core-sets for
// balls", 2003); any centre gives a right ball.
template <class Shape> MEET_HD inline void enclosing_ball(const float *row, double ball[4]) {
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

} // namespace meet

#endif
