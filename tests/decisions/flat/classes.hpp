// Every class of n labelled points that span d-space, including coincident points, each with integer points.
//
// There are three constructions; docs/decisions.md shows that each is complete:
//   n - d <= 3:   by duality, from lists of n vectors of dimension n - d - 1 (duality.cpp);
//   d = 1:        by weak orders;
//   n = 6, d = 2: by points of small grids, until every key that necessary.hpp allows has been met.
// The tests compare all of them with necessary.hpp.
#ifndef MEETC_TESTS_DECISIONS_CLASSES_HPP
#define MEETC_TESTS_DECISIONS_CLASSES_HPP

#include "tests/decisions/flat/chirotope.hpp"

#include <unordered_map>

namespace meetc::decisions_test {

// Points of each class, by key. A class and its mirror image are two classes for d >= 1.
using witnesses = std::unordered_map<key, points>;

// n <= 6, d <= 3, computed once. Throws std::logic_error if a construction gives a wrong result.
const witnesses &classes_of(int n, int d);

// Points of all classes with n - d - 1 <= 2; throws if they do not match their duals.
witnesses witnesses_by_duality(int n, int d);

// Adds the points with all permutations of their labels.
void add_relabelled(witnesses &all, const points &x, int d);

} // namespace meetc::decisions_test

#endif
