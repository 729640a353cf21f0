// bench/baselines/guigue_devillers.hpp: P. Guigue and O. Devillers, "Fast and robust triangle-triangle
// overlap test using orientation predicates", Journal of Graphics Tools 8(1), 2003.
//
// Method: only signs of orientation determinants are used. The pair is rejected where all corners of one triangle lie
// on one side of the other's plane. Otherwise each triangle is rotated so that its first corner is alone on its side of
// the other's plane, and flipped so that this side is the positive one. On the line in which the planes meet, the
// triangles are then the intervals [i, j] and [k, l], and two orientations tell whether k <= j and i <= l. Coplanar
// triangles are decided in the plane, by where the first corner of one lies relative to the other.
// Limits: the determinants are computed in T by differences, as in the authors' own program; the paper's robustness is
// that of exact determinants.
#ifndef MEETC_BENCH_BASELINES_GUIGUE_DEVILLERS_HPP
#define MEETC_BENCH_BASELINES_GUIGUE_DEVILLERS_HPP

#include "meet/bench/baselines/vectors.hpp"

MEETC_NAMESPACE(meetc::baselines) {

namespace detail {

// (d - a) . ((b - a) x (c - a)): positive where d lies above a, b, c, which are anticlockwise seen from there.
template <class T> MEETC_HD inline T volume(const vec<T> &a, const vec<T> &b, const vec<T> &c, const vec<T> &d) {
  return dot(d - a, cross(b - a, c - a));
}

template <class T> MEETC_HD inline int sign_int(T x) {
  return (x > 0) - (x < 0);
}

// The signs of three corners relative to a plane.
struct sides {
  int s0, s1, s2;
  MEETC_HD bool one_side() const { return s0 != 0 && s0 == s1 && s0 == s2; }
  MEETC_HD bool in_plane() const { return s0 == 0 && s1 == 0 && s2 == 0; }
  // The corner that is alone: its sign is above (or below) both others. There is one unless all are equal.
  MEETC_HD int alone(bool &below) const {
    below = false;
    if (s0 > s1 && s0 > s2)
      return 0;
    if (s1 > s2 && s1 > s0)
      return 1;
    if (s2 > s0 && s2 > s1)
      return 2;
    below = true;
    return s0 < s1 && s0 < s2 ? 0 : s1 < s2 && s1 < s0 ? 1 : 2;
  }
};

template <class T> struct corners {
  vec<T> p, q, r;
  MEETC_HD explicit corners(const T *t) : p(corner(t, 0)), q(corner(t, 1)), r(corner(t, 2)) {}
  MEETC_HD sides against(const corners &plane) const {
    const vec<T> n = cross(plane.p - plane.r, plane.q - plane.r);
    return {sign_int(dot(p - plane.r, n)), sign_int(dot(q - plane.r, n)), sign_int(dot(r - plane.r, n))};
  }
  MEETC_HD void turn(int first) {
    const vec<T> a = p, b = q, c = r;
    p = first == 0 ? a : first == 1 ? b : c;
    q = first == 0 ? b : first == 1 ? c : a;
    r = first == 0 ? c : first == 1 ? a : b;
  }
  MEETC_HD void flip() {
    const vec<T> old = q;
    q = r;
    r = old;
  }
};

// Anticlockwise triangles a and b in the plane, where a.p lies beyond the edge r p of b and inside the other two: the
// paper's region R1.
template <class T>
MEETC_HD inline bool from_beyond_edge(const flat<T> &p1, const flat<T> &q1, const flat<T> &r1, const flat<T> &p2,
                                      const flat<T> &r2) {
  if (area(r2, p2, q1) >= 0)
    return area(p1, p2, q1) >= 0 ? area(p1, q1, r2) >= 0 : area(q1, r1, p2) >= 0 && area(r1, p1, p2) >= 0;
  return area(r2, p2, r1) >= 0 && area(p1, p2, r1) >= 0 && (area(p1, r1, r2) >= 0 || area(q1, r1, r2) >= 0);
}

// The same where a.p lies beyond both edges that meet in the corner r of b: the region R2.
template <class T>
MEETC_HD inline bool from_beyond_corner(const flat<T> &p1, const flat<T> &q1, const flat<T> &r1, const flat<T> &p2,
                                        const flat<T> &q2, const flat<T> &r2) {
  if (area(r2, p2, q1) >= 0) {
    if (area(r2, q2, q1) <= 0)
      return area(p1, p2, q1) > 0 ? area(p1, q2, q1) <= 0 : area(p1, p2, r1) >= 0 && area(q1, r1, p2) >= 0;
    return area(p1, q2, q1) <= 0 && area(r2, q2, r1) <= 0 && area(q1, r1, q2) >= 0;
  }
  if (area(r2, p2, r1) < 0)
    return false;
  return area(q1, r1, r2) >= 0 ? area(p1, p2, r1) >= 0 : area(q1, r1, q2) >= 0 && area(r2, r1, q2) >= 0;
}

template <class T> MEETC_HD inline bool overlap_in_plane(const corners<T> &a, const corners<T> &b) {
  const int axis = longest_axis(cross(a.q - a.p, a.r - a.p));
  const flat<T> p1 = dropped(a.p, axis), p2 = dropped(b.p, axis);
  flat<T> q1 = dropped(a.q, axis), r1 = dropped(a.r, axis), q2 = dropped(b.q, axis), r2 = dropped(b.r, axis);
  if (area(p1, q1, r1) < 0) {
    const flat<T> old = q1;
    q1 = r1, r1 = old;
  }
  if (area(p2, q2, r2) < 0) {
    const flat<T> old = q2;
    q2 = r2, r2 = old;
  }
  const bool pq = area(p2, q2, p1) >= 0, qr = area(q2, r2, p1) >= 0, rp = area(r2, p2, p1) >= 0;
  if (pq && qr && rp)
    return true;
  if (pq && qr)
    return from_beyond_edge(p1, q1, r1, p2, r2);
  if (pq && rp)
    return from_beyond_edge(p1, q1, r1, r2, q2);
  if (qr && rp)
    return from_beyond_edge(p1, q1, r1, q2, p2);
  if (pq)
    return from_beyond_corner(p1, q1, r1, p2, q2, r2);
  if (qr)
    return from_beyond_corner(p1, q1, r1, q2, r2, p2);
  return from_beyond_corner(p1, q1, r1, r2, p2, q2);
}

} // namespace detail

// Whether two triangles touch.
template <class T> MEETC_HD inline bool guigue_devillers(const T *row_a, const T *row_b) {
  detail::corners<T> a(row_a), b(row_b);
  const detail::sides of_a = a.against(b);
  if (of_a.one_side())
    return false;
  const detail::sides of_b = b.against(a);
  if (of_b.one_side())
    return false;
  if (of_a.in_plane() || of_b.in_plane())
    return detail::overlap_in_plane(a, b);
  bool a_below = false, b_below = false;
  a.turn(of_a.alone(a_below));
  b.turn(of_b.alone(b_below));
  if (a_below) // the orientation of the other triangle selects the positive side
    b.flip();
  if (b_below)
    a.flip();
  return detail::volume(a.p, a.q, b.p, b.q) <= 0 && detail::volume(a.p, a.r, b.r, b.p) <= 0;
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
