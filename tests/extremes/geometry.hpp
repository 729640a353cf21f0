// The truth by geometry: it knows the operands' hulls and radii, and no predicate.
//
// Whether two bodies touch is asked of gen/oracle, which minimises a distance and proves the minimum; it has
// no orientation, no side and no turn in it, so that a decision formula that is wrong cannot be wrong here in
// the same way. A lone sign is what the specification says of it: a determinant, or a power of a point.
#ifndef MEETC_TESTS_EXTREMES_GEOMETRY_HPP
#define MEETC_TESTS_EXTREMES_GEOMETRY_HPP

#include "tests/extremes/subjects.hpp"

namespace meetc::extremes_test {

// 0 or 1; of a lone sign -1, 0 or 1.
int truth_by_geometry(const subject &s, const pair_of_rows &p);

} // namespace meetc::extremes_test

#endif
