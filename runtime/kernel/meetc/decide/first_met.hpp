// Tells the triangle that a segment meets first of two, on its way from its point p to its point q.
//
// The segment meets a triangle that its line crosses at the triangle's plane, and an emitted sign compares two planes
// (`Order`; see predicates/order.toml). A triangle that lies along the line, or has no area, has no such plane; a wall
// then takes its place: a triangle with float32 corners that the line crosses, and at the same point. Walls are judged
// by the exact answers of the emitted predicate (`Touches`) and sign alone, so there is nothing to round.
#ifndef MEETC_DECIDE_FIRST_MET_HPP
#define MEETC_DECIDE_FIRST_MET_HPP

#include <meetc/decide/first_stages.hpp>
#include <meetc/decide/later_rungs.hpp>

MEETC_NAMESPACE(meetc) {

template <class Touches, class Order> class segment_order {
  static_assert(Touches::inputs_a == 6 && Touches::inputs_b == 9 && Order::inputs_a == 6 && Order::inputs_b == 18);

public:
  // Rows: p and q; three corners.
  MEETC_HD static int of(const float *segment, const float *t, const float *u) {
    const int by_planes = crossing(segment, t, u);
    return by_planes != 0 ? by_planes : with_walls(segment, t, u);
  }

private:
  struct triangle {
    float at[9];
  };
  MEETC_HD static triangle copy(const float *row) {
    triangle t;
    for (int i = 0; i < 9; ++i)
      t.at[i] = row[i];
    return t;
  }

  // 0 if both are met at one point, or if one does not cross the line.
  MEETC_HD static int crossing(const float *segment, const float *t, const float *u) {
    float pair[18];
    for (int i = 0; i < 9; ++i)
      pair[i] = t[i], pair[9 + i] = u[i];
    if (standard_environment()) {
      const sign_set known = certify_sign_here<Order, in_fp32>(after_check(segment), after_check(&pair[0]));
      if (is_known(known))
        return before_return(static_cast<int>(known_sign(known)));
    }
#if !defined(__CUDA_ARCH__)
    return static_cast<int>(Order::after_fp32(segment, pair));
#else
    return static_cast<int>(later_rungs_sign<Order>(segment, pair));
#endif
  }
  MEETC_HD static bool touches(const float *segment, const float *t) {
#if !defined(__CUDA_ARCH__)
    return Touches::after_fp32(segment, t);
#else
    return later_rungs<Touches>(segment, t);
#endif
  }

  MEETC_HD static float other_than(float x) {
    return x == 0 ? 1.0F : 0.0F;
  }
  // The plane through x at right angles to an axis.
  MEETC_HD static triangle wall_at(const float *x, int axis) {
    triangle w = of_corners(x, x, x);
    const int i = (axis + 1) % 3, k = (axis + 2) % 3;
    w.at[3 + i] = other_than(x[i]);
    w.at[6 + k] = other_than(x[k]);
    return w;
  }
  // The plane through x and y along an axis; it has no area if x - y is along the axis too.
  MEETC_HD static triangle wall_through(const float *x, const float *y, int axis) {
    triangle w = of_corners(x, y, x);
    w.at[6 + axis] = other_than(x[axis]);
    return w;
  }
  MEETC_HD static triangle of_corners(const float *x, const float *y, const float *z) {
    triangle t;
    for (int i = 0; i < 3; ++i)
      t.at[i] = x[i], t.at[3 + i] = y[i], t.at[6 + i] = z[i];
    return t;
  }
  MEETC_HD static bool equal(const float *x, const float *y) {
    return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
  }

  // The wall that is met first.
  struct first_wall {
    triangle is;
    bool known = false;
    MEETC_HD void take(const float *segment, const triangle &w) {
      if (!known || crossing(segment, w.at, is.at) < 0)
        is = w;
      known = true;
    }
  };

  // `along` is an axis on which p and q differ.
  MEETC_HD static bool crosses(const float *segment, int along, const triangle &t) {
    return crossing(segment, wall_at(segment, along).at, t.at) != 0 ||
           crossing(segment, t.at, wall_at(segment + 3, along).at) != 0;
  }
  // Takes the wall through the first point that the segment meets on the edge from x to y, which lies in one plane with
  // the line.
  MEETC_HD static void take_edge(const float *segment, int along, const float *x, const float *y, first_wall &to) {
    if (!touches(segment, of_corners(x, y, y).at))
      return;
    if (!equal(x, y))
      for (int axis = 0; axis < 3; ++axis) {
        const triangle wall = wall_through(x, y, axis);
        if (crosses(segment, along, wall)) {
          to.take(segment, wall);
          return;
        }
      }
    // The edge lies on the line. The segment, which does not start on it, meets its nearer end first. If that is y, the edge
    // that begins there takes it.
    to.take(segment, wall_at(x, along));
  }
  // A triangle that the line crosses at the first point that the segment and t have in common. If they have none: any
  // triangle that depends on the segment and t alone.
  MEETC_HD static triangle entry(const float *segment, int along, const float *t) {
    const triangle whole = copy(t);
    if (crosses(segment, along, whole))
      return whole;
    const float start[6] = {segment[0], segment[1], segment[2], segment[0], segment[1], segment[2]};
    first_wall first;
    if (!touches(start, t))
      for (int corner = 0; corner < 3; ++corner)
        take_edge(segment, along, t + 3 * corner, t + (corner == 2 ? 0 : 3 * corner + 3), first);
    return first.known ? first.is : wall_at(segment, along);
  }
  MEETC_NOINLINE MEETC_HD static int with_walls(const float *segment, const float *t, const float *u) {
    for (int axis = 0; axis < 3; ++axis)
      if (segment[axis] != segment[3 + axis])
        return crossing(segment, entry(segment, axis, t).at, entry(segment, axis, u).at);
    return 0; // a point meets all at once
  }
};

// For rows of the predicate's kinds, with the result of predicate_info::first_met, under any control word: walls are
// found by comparisons.
template <class Touches, class Order> MEETC_HD int first_met(const float *segment, const float *t, const float *u) {
#if !defined(__CUDA_ARCH__)
  return under_standard_word([&] { return segment_order<Touches, Order>::of(segment, t, u); });
#else
  return segment_order<Touches, Order>::of(segment, t, u);
#endif
}

} // MEETC_NAMESPACE(meetc)

#endif
