// bench/truth/proved_distance.hpp: how far a wrong answer of a plain rung can at most be from being right, for one pair.
//
// Method: a plain rung computes each sign's value v within E = K M of the truth (docs/numerics.md). Where a decision is
// one comparison of the distance d of two centres with lengths, v is a product of a difference of lengths and a sum of
// lengths. A wrong sign has |v| <= E, and moving one ball along the line of centres by E divided by the sum of lengths
// therefore changes the sign. For ball_ball v = (R - d) (R + d), where R is the sum of the radii. sphere_sphere has two
// signs, this one and (d - r) (d + r), where r is the difference of the radii. Its boundaries are d = R and d = r, with
// r <= R: a ball that is moved to one of them lies on the right side of the other, so the larger of the two lengths is a
// bound for the decision.
// Limits: for other decisions errors of several signs do not add up to one motion, and no bound is known here.
#ifndef MEETC_BENCH_TRUTH_PROVED_DISTANCE_HPP
#define MEETC_BENCH_TRUTH_PROVED_DISTANCE_HPP

#include "meetc/support.hpp"

#include <string_view>

namespace meetc::bench {

// For one pair of rows of the predicate's kinds. Infinite where the rung's bound does not hold for the pair.
using proved_distance = double (*)(const float *row_a, const float *row_b);

// Null where no bound is proved: for other predicates than ball_ball and sphere_sphere, and rungs that are not plain.
proved_distance proved_distance_of(std::string_view predicate, rung precision);

} // namespace meetc::bench

#endif
