// CGAL's exact kernel as the judge of whole pair lists. Only judge.cpp sees CGAL, and its flag
// -frounding-math.
#ifndef MEETC_TESTS_CGAL_JUDGE_HPP
#define MEETC_TESTS_CGAL_JUDGE_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace meetc::cgal_test {

enum class shape { sphere, segment, triangle };
constexpr std::size_t floats_of(shape s) {
  return s == shape::triangle ? 9 : s == shape::segment ? 6 : 4;
}

// Elements as rows of floats in store order.
struct body {
  shape kind = shape::triangle;
  std::vector<float> rows;
  std::size_t size() const { return rows.size() / floats_of(kind); }
  const float *row(std::size_t i) const { return rows.data() + i * floats_of(kind); }
};

using pair_list = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// All touching pairs (i of a, j of b), sorted. Candidates by CGAL::box_intersection_d on closed boxes.
// Triangles and segments by the predicates of Exact_predicates_inexact_constructions_kernel, which are exact
// on doubles; CGAL leaves operands without area or length undefined, so they are first reduced to the segment
// or point that they are. Spheres by squared distances in rationals: solid d <= r (+ r'), surface also the
// part that lies outside. Supported: triangle with triangle or segment, sphere with sphere or triangle or
// segment (the sphere is a).
pair_list touching_pairs(const body &a, const body &b, bool surface, std::size_t *candidates = nullptr);

} // namespace meetc::cgal_test

#endif
