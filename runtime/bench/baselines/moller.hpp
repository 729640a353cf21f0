// bench/baselines/moller.hpp: T. Möller, "A fast triangle-triangle intersection test", Journal of Graphics
// Tools 2(2), 1997.
//
// Method: the pair is rejected where all corners of one triangle lie on one side of the other's plane. Otherwise each
// triangle cuts the line in which the planes meet in an interval, and the triangles touch where the intervals overlap.
// They are compared along the line's longest axis. Coplanar triangles are tested in the plane: edges against edges,
// then a corner of each against the other triangle.
// Limits: signed distances nearer to 0 than epsilon are taken as 0. The published epsilon is 1e-6, whatever the unit of
// the scene; with 0 this step is skipped. As published, signs are compared by products, which may underflow.
#ifndef MEETC_BENCH_BASELINES_MOLLER_HPP
#define MEETC_BENCH_BASELINES_MOLLER_HPP

#include "meet/bench/baselines/vectors.hpp"

MEETC_NAMESPACE(meetc::baselines) {

inline constexpr double moller_epsilon = 1e-6;

namespace detail {

template <class T> struct plane {
  vec<T> normal;
  T offset;
  MEETC_HD explicit plane(const T *t)
      : normal(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0))), offset(-dot(normal, corner(t, 0))) {}
};

// The signed distances of a triangle's corners to a plane, multiplied by the length of its normal.
template <class T> struct distances {
  T d0, d1, d2;
  MEETC_HD distances(const plane<T> &to, const T *t, T epsilon)
      : d0(one(to, t, 0, epsilon)), d1(one(to, t, 1, epsilon)), d2(one(to, t, 2, epsilon)) {}
  MEETC_HD distances(T x, T y, T z) : d0(x), d1(y), d2(z) {}
  MEETC_HD static T one(const plane<T> &to, const T *t, int i, T epsilon) {
    const T d = dot(to.normal, corner(t, i)) + to.offset;
    return magnitude(d) < epsilon ? T(0) : d;
  }
  MEETC_HD bool one_side() const { return d0 * d1 > 0 && d0 * d2 > 0; }
  MEETC_HD bool in_plane() const { return d0 == 0 && d1 == 0 && d2 == 0; }
};

template <class T> struct interval { T low, high; };
// Where the two edges of the corner `a`, which is alone on its side, cross the plane. p: positions along the axis of
// the line.
template <class T> MEETC_HD inline interval<T> crossings(T pa, T pb, T pc, T da, T db, T dc) {
  const T s = pa + (pb - pa) * da / (da - db), t = pa + (pc - pa) * da / (da - dc);
  return s <= t ? interval<T>{s, t} : interval<T>{t, s};
}
// Not for a triangle in the plane.
template <class T> MEETC_HD inline interval<T> cut(const T *t, int axis, const distances<T> &d) {
  const T p0 = along(corner(t, 0), axis), p1 = along(corner(t, 1), axis), p2 = along(corner(t, 2), axis);
  if (d.d0 * d.d1 > 0)
    return crossings(p2, p0, p1, d.d2, d.d0, d.d1);
  if (d.d0 * d.d2 > 0)
    return crossings(p1, p0, p2, d.d1, d.d0, d.d2);
  if (d.d1 * d.d2 > 0 || d.d0 != 0)
    return crossings(p0, p1, p2, d.d0, d.d1, d.d2);
  if (d.d1 != 0)
    return crossings(p1, p0, p2, d.d1, d.d0, d.d2);
  return crossings(p2, p0, p1, d.d2, d.d0, d.d1);
}

// Edges v0 v1 and u0 u1 in the plane: v0 + (d / f) (v1 - v0) = u0 + (e / f) (u1 - u0), without division. Parallel edges
// do not count as a hit; where they overlap, other edges of the same triangles do.
template <class T>
MEETC_HD inline bool edges_cross(const flat<T> &v0, const flat<T> &v1, const flat<T> &u0, const flat<T> &u1) {
  const flat<T> a{v1.x - v0.x, v1.y - v0.y}, b{u0.x - u1.x, u0.y - u1.y}, c{v0.x - u0.x, v0.y - u0.y};
  const T f = a.y * b.x - a.x * b.y, d = b.y * c.x - b.x * c.y, e = a.x * c.y - a.y * c.x;
  return f > 0 ? d >= 0 && d <= f && e >= 0 && e <= f : f < 0 && d <= 0 && d >= f && e <= 0 && e >= f;
}

template <class T> struct flat_triangle {
  flat<T> p0, p1, p2;
  MEETC_HD flat_triangle(const T *t, int axis)
      : p0(dropped(corner(t, 0), axis)), p1(dropped(corner(t, 1), axis)), p2(dropped(corner(t, 2), axis)) {}
  MEETC_HD bool crossed_by(const flat<T> &v0, const flat<T> &v1) const {
    return edges_cross(v0, v1, p0, p1) || edges_cross(v0, v1, p1, p2) || edges_cross(v0, v1, p2, p0);
  }
  MEETC_HD bool holds(const flat<T> &p) const {
    const T a = area(p0, p1, p), b = area(p1, p2, p), c = area(p2, p0, p);
    return a * b > 0 && a * c > 0;
  }
};

template <class T> MEETC_HD inline bool coplanar(const vec<T> &normal, const T *a, const T *b) {
  const int axis = longest_axis(normal);
  const flat_triangle<T> v(a, axis), u(b, axis);
  return u.crossed_by(v.p0, v.p1) || u.crossed_by(v.p1, v.p2) || u.crossed_by(v.p2, v.p0) || u.holds(v.p0) ||
         v.holds(u.p0);
}

} // namespace detail

// The rest of the test when each plane separates the other triangle's corners: db are the distances of b's corners to
// the plane of a, da those of a's to the plane of b.
template <class T>
MEETC_HD inline bool moller_beyond_planes(const T *a, const vec<T> &normal_a, const detail::distances<T> &da,
                                          const T *b, const vec<T> &normal_b, const detail::distances<T> &db) {
  if (da.in_plane() || db.in_plane())
    return detail::coplanar(normal_a, a, b);
  const int axis = longest_axis(cross(normal_a, normal_b));
  const detail::interval<T> cut_a = detail::cut(a, axis, da), cut_b = detail::cut(b, axis, db);
  return cut_a.low <= cut_b.high && cut_b.low <= cut_a.high;
}

// Whether two triangles touch.
template <class T> MEETC_HD inline bool moller(const T *a, const T *b, T epsilon) {
  const detail::plane<T> of_a(a);
  const detail::distances<T> db(of_a, b, epsilon);
  if (db.one_side())
    return false;
  const detail::plane<T> of_b(b);
  const detail::distances<T> da(of_b, a, epsilon);
  if (da.one_side())
    return false;
  return moller_beyond_planes(a, of_a.normal, da, b, of_b.normal, db);
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
