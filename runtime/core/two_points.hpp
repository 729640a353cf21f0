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

// The row is finite; the kind has two points.
inline two_points two_points_of(const kind_info &kind, const float *row) {
  const auto coordinate = [&](int i) { return kind.hull_fields[i] < 0 ? 0.0f : row[kind.hull_fields[i]]; };
  two_points t;
  for (int k = 0; k < 3; ++k) {
    const float from = coordinate(k);
    const double way = static_cast<double>(coordinate(3 + k)) - static_cast<double>(from);
    const double length = way < 0 ? -way : way;
    t.per[k] = way == 0                                  ? std::numeric_limits<float>::infinity()
               : length >= 0x1p-126 && length <= 0x1p126 ? static_cast<float>(1 / way)
                                                         : std::numeric_limits<float>::quiet_NaN();
    t.enter[k] = t.leave[k] = from;
    if (kind.pad >= 0) {
      const float below = step_down(from - row[kind.pad]), above = step_up(from + row[kind.pad]);
      t.enter[k] = t.per[k] < 0 ? below : above;
      t.leave[k] = t.per[k] < 0 ? above : below;
    }
  }
  return t;
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
  for (int i = 0; i < lanes; ++i) {
    float in = 0, out = 1;
    for (int k = 0; k < 3; ++k) {
      const float entry = (first[k][i] - t.enter[k]) * t.per[k], exit = (last[k][i] - t.leave[k]) * t.per[k];
      in = entry > in ? entry : in;
      out = exit < out ? exit : out;
    }
    const bool apart = in > out * margin.factor + margin.term;
    mask |= apart ? 0 : lane_bit[i];
  }
  return mask;
}

} // namespace meetc

#endif
