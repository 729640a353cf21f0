// The possible sign vectors of determinants: all that contradict no identity of a given list.
//
// The determinants of any real points satisfy identities. If under a sign vector the terms of one identity are
// not all zero but have one sign, no points have that sign vector. The list therefore contains all keys; if each
// of them has points, it is the list of classes.
#ifndef MEETC_TESTS_DECISIONS_NECESSARY_HPP
#define MEETC_TESTS_DECISIONS_NECESSARY_HPP

#include "tests/decisions/flat/chirotope.hpp"

namespace meetc::decisions_test {

// For n points that span d-space, in ascending order. The identities, for columns (1, x):
//   any d + 2 points:                       the alternating sum of their d + 2 determinants is 0;
//   any d - 1 points A and any b, c, d, e:  [A b c][A d e] - [A b d][A c e] + [A b e][A c d] = 0.
std::vector<key> possible_keys(int n, int d);

} // namespace meetc::decisions_test

#endif
