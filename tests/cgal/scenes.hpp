// Bodies, poses, and the one check of this folder: meet's pair list against CGAL's, pair for pair.
#ifndef MEETC_TESTS_CGAL_SCENES_HPP
#define MEETC_TESTS_CGAL_SCENES_HPP

#include "meet/bodies/meshes.hpp"
#include "tests/cgal/judge.hpp"

#include <array>
#include <string>

namespace meetc::cgal_test {

body triangles_of(const meetc::bodies::mesh &m);
body segments_of(const std::vector<float> &rows);
body spheres_of(const std::vector<float> &rows);

// Rotated about an axis through the origin, scaled and moved: in double, rounded once to float32.
struct placing {
  std::array<double, 3> axis = {0, 0, 1};
  double degrees = 0, scale = 1;
  std::array<double, 3> move = {0, 0, 0};
};
body placed(const body &b, const placing &at);
// Each coordinate c becomes float(c * factor) + offset, in float32 arithmetic; radii are scaled.
body in_float32(const body &b, float factor, float offset);

// Compares and reports (CHECK); the number of touching pairs. Pairs with an operand without extent count,
// too.
std::size_t same_pairs(const std::string &name, const body &a, const body &b, bool surface = false);

} // namespace meetc::cgal_test

#endif
