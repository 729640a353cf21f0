// The test of an element whose hull has two points against a box.
//
// Problem: the box of a long element holds far more than the element. Method: the separating axes of a segment and a
// box, which are the three axes and their cross products with the segment's direction (Kay and Kajiya 1986). The
// element lies within a radius r (0 for a segment) of the points p + t d with 0 <= t <= 1. If it touches a box, then
// some such point lies in the box widened by r, that is, in three slabs. Let e_k be the parameter t at which the line
// enters the slab of axis k, and x_k the one at which it leaves. The two are apart if max(0, e_0, e_1, e_2) > min(1,
// x_0, x_1, x_2): e_i > x_j, for two axes, is a separation along the cross product of the third with d, and e_k > 1 or
// x_k < 0 is one along axis k.
//
// It is a filter: a pair that it calls apart is proved apart. In float32 the parameter at which a side s is reached is
//   fl(fl(s - p') * q),  q = fl32(fl64(1 / fl64(p1 - p0))),
// where p' is p without a radius, and else p moved by r and rounded in the direction that widens the slab. The computed
// parameter is within (1 +- 2^-24)^2 (1 +- 2^-24 +- 2^-51) of the true one at any scale, and within 2^-150 more if the
// product is subnormal; a difference is never rounded there. The two are called apart only if
//   max(0, entries) > fl(fl(min(1, exits) * (1 + 5 * 2^-23)) + 2^-126).
//
// Proof. Let the two touch at t, let e <= t be an entry and x >= t an exit, and N and F their computed values. If N <=
// 0, the left side is 0 for this entry, and the right side is positive, because F has the sign of x. If F >= 1, take F
// = x = 1 without an error. Gappa proves N <= fl(fl(F * (1 + 5 * 2^-23)) + 2^-126) from 0 <= e <= 1, 0 <= x <= 2, e <=
// x and the errors above (tests/proofs/two_points.gappa), and Coq checks its proof. If a difference or a product
// overflows, its sign is right and the true parameter exceeds 1 in magnitude, so an entry is below 0 and an exit above
// 1. If p1 = p0 along an axis, q is infinite: a side beyond p' gives an infinity of the right sign, and a side at p'
// gives NaN. If |p1 - p0| exceeds 2^126 or lies between 0 and 2^-126, q is NaN. NaN passes no comparison, so it
// separates nothing. Contraction only removes roundings. The proof assumes only that a box holds its content,
// however its sides were rounded, so it is the same for the boxes of a hierarchy.
#ifndef MEETC_VOLUME_TWO_POINTS_HPP
#define MEETC_VOLUME_TWO_POINTS_HPP

#include <meetc/support.hpp>

#include <cmath>

namespace meetc {

// The line from one hull point to the other. The slab of axis k is entered at (side - enter[k]) * per[k] and left at
// (side - leave[k]) * per[k].
struct two_points {
  float enter[3], leave[3]; // the first point, moved by the radius in the direction that widens the slab
  float per[3]; // 1 / (second - first): infinite where that is 0; NaN, which is no information, beyond 2^126 and 2^-126
};

// The margin by which an entry must exceed an exit: the factor covers eight roundings, the term is the least normal
// number.
struct parameter_margin {
  float factor = 0x1.00000ap+0f, term = 0x1p-126f;
};

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

} // namespace meetc

#endif
