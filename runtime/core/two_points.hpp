// core/two_points.hpp: the test of an element whose hull has two points against sixteen boxes.
//
// Problem: the box of a long element holds far more than the element. Method: the separating axes of a segment and a
// box, which are the three axes and their cross products with the segment's direction. The segment enters and leaves
// the slab of each axis at two parameters; that an entry lies after an exit is a separation along a cross product, and
// that one of them lies beyond an end of the segment is one along an axis (Kay and Kajiya 1986). A radius around the
// segment widens each slab.
//
// It is a filter: what it calls apart is proved apart. A parameter is the difference of two stored numbers times a
// reciprocal; its relative error is therefore at most three roundings at any scale, apart from underflow. Each entry
// must exceed each exit by the factor and the term below (tests/proofs/two_points.gappa). Where a difference or a
// parameter overflows, its sign is right and its true value is above 1. NaN, in any place, separates nothing.
#ifndef MEETC_CORE_TWO_POINTS_HPP
#define MEETC_CORE_TWO_POINTS_HPP

#include "core/box.hpp"
#include "meetc/support.hpp"

#include <cmath>

namespace meetc {

// The line from one hull point to the other. The slab of axis k is entered at (side - enter[k]) * per[k] and left at
// (side - leave[k]) * per[k].
struct two_points {
  float enter[3], leave[3]; // the first point, moved by the radius in the direction that widens the slab
  float per[3]; // 1 / (second - first): infinite where that is 0; NaN, which is no information, beyond 2^126 and 2^-126
};

// What an entry must exceed an exit by: the factor covers eight roundings, the term is the least normal number.
struct parameter_margin {
  float factor = 0x1.00000ap+0f, term = 0x1p-126f;
};

// Whether the candidates of this kind are to be tested by their two points.
inline bool has_two_points(const kind_info &kind) {
  return kind.hull == 2;
}

// Where a row has its two points, and its radius. Fields below 0: a coordinate that is 0, and no radius.
struct point_fields {
  int of[6], pad;
};
inline point_fields point_fields_of(const kind_info &kind) {
  point_fields p{{}, kind.pad};
  for (int i = 0; i < 6; ++i)
    p.of[i] = kind.hull_fields[i];
  return p;
}

// The row is finite.
MEETC_HD inline two_points two_points_of(const point_fields &fields, const float *row) {
  two_points t;
  for (int k = 0; k < 3; ++k) {
    const float from = fields.of[k] < 0 ? 0.0f : row[fields.of[k]],
                to = fields.of[3 + k] < 0 ? 0.0f : row[fields.of[3 + k]];
    const double way = static_cast<double>(to) - static_cast<double>(from);
    const double length = way < 0 ? -way : way;
    t.per[k] = way == 0 ? HUGE_VALF : length >= 0x1p-126 && length <= 0x1p126 ? static_cast<float>(1 / way) : NAN;
    t.enter[k] = t.leave[k] = from;
    if (fields.pad >= 0) {
      const float below = step_down(from - row[fields.pad]), above = step_up(from + row[fields.pad]);
      t.enter[k] = t.per[k] < 0 ? below : above;
      t.leave[k] = t.per[k] < 0 ? above : below;
    }
  }
  return t;
}
// The kind has two points.
inline two_points two_points_of(const kind_info &kind, const float *row) {
  return two_points_of(point_fields_of(kind), row);
}

// Whether the element is apart from a finite box, whose sides on axis k are first[k] and last[k] in the element's direction:
// low and high, or high and low where per[k] < 0.
MEETC_HD inline bool apart(const two_points &t, const float (&first)[3], const float (&last)[3],
                           parameter_margin margin = {}) {
  float in = 0, out = 1;
  for (int k = 0; k < 3; ++k) {
    const float entry = (first[k] - t.enter[k]) * t.per[k], exit = (last[k] - t.leave[k]) * t.per[k];
    in = entry > in ? entry : in;
    out = exit < out ? exit : out;
  }
  return in > out * margin.factor + margin.term;
}

// The same for a box by its ends.
MEETC_HD inline bool apart_from_box(const two_points &t, const float (&low)[3], const float (&high)[3]) {
  float first[3], last[3];
  for (int k = 0; k < 3; ++k) {
    const bool down = t.per[k] < 0;
    first[k] = down ? high[k] : low[k], last[k] = down ? low[k] : high[k];
  }
  return apart(t, first, last);
}

// Bit i is set where lane i of the block may touch the element. Lanes must be finite boxes; for others the answer means
// nothing.
inline std::uint32_t touching(const box_block &block, const two_points &t, parameter_margin margin = {}) {
  const float *first[3], *last[3];
  for (int k = 0; k < 3; ++k) {
    first[k] = t.per[k] < 0 ? block.hi[k] : block.lo[k];
    last[k] = t.per[k] < 0 ? block.lo[k] : block.hi[k];
  }
  std::uint32_t mask = 0;
  for (int i = 0; i < lanes; ++i)
    mask |= apart(t, {first[0][i], first[1][i], first[2][i]}, {last[0][i], last[1][i], last[2][i]}, margin)
                ? 0
                : lane_bit[i];
  return mask;
}

} // namespace meetc

#endif
