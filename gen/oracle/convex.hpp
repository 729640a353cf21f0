// Exact distances of convex hulls, and from them the rule that says when two bodies touch.
//
// This judges the predicates, so it shares nothing with their sign formulas: no orientation, no side, no
// turn, no crossing. It solves the quadratic programme "nearest points of two hulls" and proves each answer
// by its optimality conditions.
#ifndef MEETC_GEN_ORACLE_CONVEX_HPP
#define MEETC_GEN_ORACLE_CONVEX_HPP

#include <array>
#include <gmpxx.h>
#include <vector>

namespace meetc::oracle {

using rational = mpq_class;
using point = std::array<rational, 3>;

// A point; in the plane, leave z out.
[[nodiscard]] point at(const rational &x, const rational &y, const rational &z = 0);

// The convex hull of its points: 1 a point, 2 a segment, 3 a triangle (more are allowed, but slow). Points
// may repeat or be collinear: the hull is then the segment or the point that it is. An empty hull is an error
// (std::invalid_argument).
using hull = std::vector<point>;

// The square of the least distance of a point of a and a point of b; 0 when they share a point.
[[nodiscard]] rational squared_distance(const hull &a, const hull &b);

// The square of the greatest distance of p and a point of a. A distance is convex, so a corner attains it.
[[nodiscard]] rational max_squared_distance(const point &p, const hull &a);

// What a pad makes of a hull.
//   solid:   all points within `pad` of the hull (a ball, a capsule; the hull itself where the pad is 0).
//   surface: a padded hull must be one point c, and is the sphere surface |x - c| = pad; pad 0 leaves the
//   hull. (A
//            surface of radius 0 and a bare point are one set, so there is nothing to tell apart.)
enum class touch_mode { solid, surface };

// Whether the two closed bodies share a point, decided on squares alone. A negative pad, or in surface mode a
// pad on a hull of several points, is an error (std::invalid_argument).
//   solid:              d <= pad_a + pad_b
//   two surfaces:       |pad_a - pad_b| <= d <= pad_a + pad_b   (identical: touch; nested: do not)
//   surface and hull:   least distance of centre and hull <= pad <= greatest
[[nodiscard]] bool touches(const hull &a, const rational &pad_a, const hull &b, const rational &pad_b, touch_mode mode);

} // namespace meetc::oracle

#endif
