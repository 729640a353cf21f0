// Exact distances of convex hulls, and the rule derived from them that says when two bodies touch.
//
// This is the judge of the predicates, so it shares nothing with their sign formulas: no orientation, side, turn or
// crossing. It solves the quadratic programme "nearest points of two hulls" and proves each answer by its optimality
// conditions.
#ifndef MEETC_GEN_ORACLE_CONVEX_HPP
#define MEETC_GEN_ORACLE_CONVEX_HPP

#include <array>
#include <gmpxx.h>
#include <vector>

namespace meetc::oracle {

using rational = mpq_class;
using point = std::array<rational, 3>;

// A point. In the plane, leave z out.
[[nodiscard]] point at(const rational &x, const rational &y, const rational &z = 0);

// The convex hull of its points: one is a point, two a segment, three a triangle (more are allowed, but slow). Points
// may repeat or be collinear; the hull is then a segment or a point. An empty hull is an error (std::invalid_argument).
using hull = std::vector<point>;

// The square of the least distance between a point of a and a point of b; 0 where they share a point.
[[nodiscard]] rational squared_distance(const hull &a, const hull &b);

// Points of which the common part of two hulls is the hull; none where they share no point.
[[nodiscard]] std::vector<point> common_part(const hull &a, const hull &b);

// The square of the greatest distance between p and a point of a. The distance is convex, so a corner attains it.
[[nodiscard]] rational max_squared_distance(const point &p, const hull &a);

// The body that a hull and a pad describe.
//   solid:   all points within `pad` of the hull (a ball, a capsule; the hull itself where the pad is 0).
//   surface: a padded hull must be one point c, and is the surface of the sphere |x - c| = pad. With pad 0 it is the hull.
//            (A surface of radius 0 and a bare point are one set, so they need not be told apart.)
enum class touch_mode { solid, surface };

// Whether the two closed bodies share a point, decided by squares alone. A negative pad, or in surface mode a pad on a
// hull of several points, is an error (std::invalid_argument).
//   solid:              d <= pad_a + pad_b
//   two surfaces:       |pad_a - pad_b| <= d <= pad_a + pad_b   (identical ones touch; nested ones do not)
//   surface and hull:   least distance of centre and hull <= pad <= greatest
[[nodiscard]] bool touches(const hull &a, const rational &pad_a, const hull &b, const rational &pad_b, touch_mode mode);

} // namespace meetc::oracle

#endif
