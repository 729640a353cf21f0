// Two exact judges of whether two bodies touch, for any finite float32 rows.
#ifndef MEETC_TESTS_GENERATED_JUDGE_HPP
#define MEETC_TESTS_GENERATED_JUDGE_HPP

#include "gen/oracle/convex.hpp"
#include "tests/generated/judge/predicates.hpp"

namespace meetc::generated_test {

// The corners of a row, exactly; and its radius, 0 where it has none.
oracle::hull hull_of(shape kind, const row &r);
mpq_class pad_of(shape kind, const row &r);

// Judges by the compiler's oracle: exact distances from optimality conditions (gen/oracle/convex.hpp).
bool touching(shape a, const row &x, shape b, const row &y, bool surface);

// Judges by separating axes, in integers, for shapes without a radius. It shares nothing with the oracle. Two polytopes
// are apart iff 0 lies outside D = A - B. The normals of the facets of D, within its affine hull and across it, are
// among the axes tried: cross products of edges where D is solid; the one normal and its products with edges where D is
// flat; the normals of its line where D is thin.
bool touching_by_axes(shape a, const row &x, shape b, const row &y);

} // namespace meetc::generated_test

#endif
