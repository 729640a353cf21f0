// bench/baselines/baselines.hpp: the classic floating-point tests that our predicates are compared with.
//
// Problem: a time says little without the time of what others use, measured in the same run.
// Method: each test is written as in its paper, as a plain function of two rows, in float or double, on host and
// device. A row is x y z r (ball), three corners (triangle) or two ends (segment).
// Source: Möller 1997, Guigue and Devillers 2003, Möller and Trumbore 1997 (cited beside each).
// Limits: these tests use rounded numbers. Where the geometry is nearly degenerate they can be wrong, and Möller's
// epsilons are lengths in the unit of the scene.
#ifndef MEETC_BENCH_BASELINES_BASELINES_HPP
#define MEETC_BENCH_BASELINES_BASELINES_HPP

#include "meet/bench/baselines/guigue_devillers.hpp"
#include "meet/bench/baselines/moller.hpp"
#include "meet/bench/baselines/vectors.hpp"

MEETC_NAMESPACE(meetc::baselines) {

// Boxes: their least and their greatest corners.
template <class T> MEETC_HD inline bool boxes(const T *a, const T *b) {
  return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4] && a[2] <= b[5] && b[2] <= a[5];
}

// Solid balls: d^2 <= (r1 + r2)^2.
template <class T> MEETC_HD inline bool balls(const T *a, const T *b) {
  const vec<T> d = corner(a, 0) - corner(b, 0);
  const T reach = a[3] + b[3];
  return dot(d, d) <= reach * reach;
}

// Segment a = (p, q) against triangle b: T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection",
// Journal of Graphics Tools 2(1), 1997, without culling. The barycentric coordinates u, v and the position t on the
// segment solve p + t (q - p) = (1 - u - v) b0 + u b1 + v b2 by Cramer's rule. The paper's epsilon for the determinant
// is 1e-6. A segment in the triangle's plane is never a hit. Returns t, or -1 where there is no hit.
template <class T> MEETC_HD inline T moller_trumbore_position(const T *a, const T *b, T epsilon) {
  constexpr T none = -1;
  const vec<T> p = corner(a, 0), way = corner(a, 1) - p;
  const vec<T> edge1 = corner(b, 1) - corner(b, 0), edge2 = corner(b, 2) - corner(b, 0);
  const vec<T> across = cross(way, edge2);
  const T determinant = dot(edge1, across);
  if (determinant == 0 || (determinant > -epsilon && determinant < epsilon))
    return none;
  const T inverse = 1 / determinant;
  const vec<T> from = p - corner(b, 0);
  const T u = dot(from, across) * inverse;
  if (u < 0 || u > 1)
    return none;
  const vec<T> turned = cross(from, edge1);
  const T v = dot(way, turned) * inverse;
  if (v < 0 || u + v > 1)
    return none;
  const T t = dot(edge2, turned) * inverse;
  return t >= 0 && t <= 1 ? t : none;
}

// Whether there is a hit.
template <class T> MEETC_HD inline bool moller_trumbore(const T *a, const T *b, T epsilon) {
  return moller_trumbore_position(a, b, epsilon) >= 0;
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
