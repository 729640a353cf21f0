// Every class of n labelled points that span d-space, coincident points included, each with integer points.
//
// Three constructions, each complete for a reason of its own (docs/decisions.md):
//   n - d <= 3:   by duality, from lists of n vectors of dimension n - d - 1 (duality.cpp);
//   d = 1:        by weak orders;
//   n = 6, d = 2: by points of small grids, until every key that necessary.hpp allows has been met.
// The tests hold all of them against necessary.hpp.
#ifndef MEETC_TESTS_DECISIONS_CLASSES_HPP
#define MEETC_TESTS_DECISIONS_CLASSES_HPP

#include "tests/decisions/flat/chirotope.hpp"

#include <unordered_map>

namespace meetc::decisions_test {

// Points of each class, by key. A class and its mirror image are two classes for d >= 1.
using witnesses = std::unordered_map<key, points>;

// n <= 6, d <= 3, computed once. Throws std::logic_error where a construction does not give what it must.
const witnesses &classes_of(int n, int d);

// Points of all classes with n - d - 1 <= 2; throws where they do not match their duals.
witnesses witnesses_by_duality(int n, int d);

// Adds points and all that differ from them by their labels.
void add_relabelled(witnesses &all, const points &x, int d);

} // namespace meetc::decisions_test

#endif
