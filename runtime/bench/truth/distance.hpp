// bench/truth/distance.hpp: how far an answer is from being right: the least translation of one element that changes it.
//
// Problem: a count of wrong answers does not say how wrong they are. A wrong answer about two triangles that are 10^-12
// apart harms few; one about triangles that are a millimetre apart may harm many.
// Method: both elements are convex hulls of points, padded by a length. The points of the Minkowski difference are the
// differences of their points. The distance of two hulls is that of the origin from the hull of these differences: the
// least over the affine hulls of one, two and three of them whose foot has no negative weight. The depth of two hulls that
// touch is the least over all directions of how far one must go until a plane at right angles to the direction parts
// them; a facet gives the least one, so the normals of all triples are tried. Everything is in double-double, on
// differences that are taken from one point of the pair.
// Limits: what is smaller than 2^-80 of the largest coordinate difference is lost in rounding. For a surface around a
// hull of several points, the length that would enclose that hull is a lower bound.
#ifndef MEETC_BENCH_TRUTH_DISTANCE_HPP
#define MEETC_BENCH_TRUTH_DISTANCE_HPP

#include "meetc/support.hpp"

namespace meetc::bench {

// Whether distances are known for the predicate's pairs: both kinds have a hull of at most four points.
bool has_distances(const predicate_info &p);

// The length of the shortest translation of one of the elements after which the right answer is the other one, or a
// length below every longer one that does it; 0 where arbitrarily small ones do. `touch`: the right answer. Where the
// predicate's mode is "surface", a padded element of one point is the surface around it, and not the ball.
double distance_from_change(const predicate_info &p, const float *row_a, const float *row_b, bool touch);

// The length of one unit in the last place of the largest stored number of the two rows, in float.
double ulp_of_pair(const predicate_info &p, const float *row_a, const float *row_b);

} // namespace meetc::bench

#endif
