// The truth by geometry: it knows the operands' hulls and radii, and no predicate.
//
// gen/oracle decides whether two bodies touch. It minimises a distance and proves the minimum, without orientation,
// side or turn, so a wrong decision formula cannot be wrong here in the same way. A lone sign is what the specification
// says: that of a determinant, or of the power of a point.
#ifndef MEETC_TESTS_EXTREMES_GEOMETRY_HPP
#define MEETC_TESTS_EXTREMES_GEOMETRY_HPP

#include "tests/extremes/families/subjects.hpp"

namespace meetc::extremes_test {

// 0 or 1, or -1, 0 or 1 for a lone sign.
int truth_by_geometry(const subject &s, const pair_of_rows &p);

} // namespace meetc::extremes_test

#endif
