// Placements of classes in space: points of d-space under an injective linear map with integer coefficients.
#ifndef MEETC_TESTS_DECISIONS_PLACEMENT_HPP
#define MEETC_TESTS_DECISIONS_PLACEMENT_HPP

#include "gen/oracle/convex.hpp"
#include "tests/decisions/flat/chirotope.hpp"

#include <map>

namespace meetc::decisions_test {

// The images of the unit vectors; and the direction that gives the signs of turns and differences: the cross
// product of two vectors, a single vector itself, else 0.
struct placement {
  std::vector<place> image;
  place direction;
};

// d = 2: planes, and d = 1: lines, one for each sign vector of the direction up to its negative, 13 in all: a
// negative direction with a class is the direction with the mirror image of the class. d = 3: the identity, and
// three maps that keep orientations: one that moves every axis, and two that flatten space so that opposite edges
// of a corner tetrahedron, or a corner and a face, meet in all three projections along axes. d = 0: one.
const std::vector<placement> &placements(int d);

points placed(const points &x, const placement &p);

// Whether the hulls of the first m points and of the others share a point, by exact distances (gen/oracle).
// Lists of points with the same two hulls are judged once.
class judge {
public:
  bool touching(const points &x, std::size_t m);
  std::size_t asked() const { return answers_.size(); }

private:
  std::map<std::pair<points, points>, bool> answers_;
};

} // namespace meetc::decisions_test

#endif
