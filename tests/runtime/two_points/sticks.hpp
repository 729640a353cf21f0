// Toy kinds with two hull points for the tests of core, and the exact test of one against a box, by separating axes in
// rational numbers.
#ifndef MEETC_TESTS_CORE_STICKS_HPP
#define MEETC_TESTS_CORE_STICKS_HPP

#include "meet/core/hierarchy/two_points.hpp"
#include "tests/runtime/core/toy.hpp"

#include <gmpxx.h>

namespace toy {

using meetc::box;

// ---- sticks: x0,y0,z0,x1,y1,z1; padded sticks have a radius r as well ----
inline constexpr int stick_fields[6] = {0, 1, 2, 3, 4, 5};
inline constexpr kind_info sticks{"stick", "x0,y0,z0,x1,y1,z1", 6, box_roles, 2, boxes_by<6, rod_box>, nullptr, 0,
                                  2,       stick_fields,        -1};
inline void padded_box(const float *r, float lo[3], float hi[3]) {
  rod_box(r, lo, hi);
  for (int k = 0; k < 3; ++k) {
    lo[k] = meetc::step_down(lo[k] - r[6]);
    hi[k] = meetc::step_up(hi[k] + r[6]);
  }
}
inline constexpr role padded_roles[7] = {role::x, role::y, role::z, role::x, role::y, role::z, role::length};
inline constexpr kind_info padded_sticks{
    "padded stick", "x0,y0,z0,x1,y1,z1,r", 7, padded_roles, 0, boxes_by<7, padded_box>, nullptr, 0, 2, stick_fields, 6};

// Whether the segment of a row touches the box, widened by the row's radius on every side: the six separating axes.
inline bool meets(const kind_info &kind, const float *row, const box &b) {
  const mpq_class r = kind.pad < 0 ? mpq_class(0) : mpq_class(row[kind.pad]);
  mpq_class p[3], q[3], lo[3], hi[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = row[kind.hull_fields[k]], q[k] = row[kind.hull_fields[3 + k]];
    lo[k] = b.lo[k] - r, hi[k] = b.hi[k] + r;
    if (std::max(p[k], q[k]) < lo[k] || hi[k] < std::min(p[k], q[k]))
      return false;
  }
  for (int k = 0; k < 3; ++k) { // the cross product of axis k and the segment; the segment is one point along it
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const mpq_class along_i = q[j] - p[j], along_j = p[i] - q[i];
    const mpq_class at = along_i * p[i] + along_j * p[j];
    const mpq_class i0 = along_i * lo[i], i1 = along_i * hi[i], j0 = along_j * lo[j], j1 = along_j * hi[j];
    if (std::min(i0, i1) + std::min(j0, j1) > at || std::max(i0, i1) + std::max(j0, j1) < at)
      return false;
  }
  return true;
}

inline box box_of(const kind_info &kind, const float *row) {
  box b;
  kind.box(row, b.lo, b.hi);
  return meetc::sanitised(b);
}

// The exact predicates: every element with two points meets the other's box, and the boxes meet.
template <const kind_info &A, const kind_info &B> bool met(const float *a, const float *b) {
  const box x = box_of(A, a), y = box_of(B, b);
  bool hit = true;
  for (int k = 0; k < 3; ++k)
    hit &= x.lo[k] <= y.hi[k] && y.lo[k] <= x.hi[k];
  return hit && (A.hull != 2 || meets(A, a, y)) && (B.hull != 2 || meets(B, b, x));
}
template <const kind_info &A, const kind_info &B> constexpr meetc::predicate_info exactly_met() {
  return plain("met", "", A, B, decide<A.fields, B.fields, met<A, B>>, decide<A.fields, B.fields, met<A, B>>);
}
inline constexpr meetc::predicate_info stick_box = exactly_met<sticks, boxes>(),
                                       box_stick = exactly_met<boxes, sticks>(),
                                       stick_stick = exactly_met<sticks, sticks>(),
                                       padded_stick_box = exactly_met<padded_sticks, boxes>(),
                                       box_padded_stick = exactly_met<boxes, padded_sticks>();

} // namespace toy

#endif
