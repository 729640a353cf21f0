// CGAL's self-intersections of a triangle mesh. Only self_judge.cpp sees CGAL, and its flag -frounding-math.
#ifndef MEETC_TESTS_CGAL_SELF_JUDGE_HPP
#define MEETC_TESTS_CGAL_SELF_JUDGE_HPP

#include "tests/cgal/judge.hpp"

#include <optional>
#include <vector>

namespace meetc::cgal_test {

// The pairs i < j of faces that intersect as CGAL's self_intersections() says, sorted. It leaves out all pairs of a face
// without area. Nothing where the faces are no manifold mesh.
std::optional<pair_list> self_intersections(const std::vector<float> &xyz, const std::vector<std::uint32_t> &index);

} // namespace meetc::cgal_test

#endif
