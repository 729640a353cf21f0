// CGAL's exact intersections, and its curves of two meshes, as the judge of contacts. Only contacts_judge.cpp sees CGAL.
#ifndef MEETC_TESTS_CGAL_CONTACTS_JUDGE_HPP
#define MEETC_TESTS_CGAL_CONTACTS_JUDGE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace meetc::cgal_test {

// Numerator and denominator of x, y and z.
using fraction_point = std::array<std::string, 6>;

// The extreme points of what two rows of 2 or 3 corners have in common; none where one of them has no area or length, which
// CGAL leaves undefined.
std::optional<std::set<fraction_point>> common_points(const float *a, int corners_a, const float *b);

struct curves {
  std::size_t nodes = 0, polylines = 0, closed = 0;
};
// The curves in which two manifold meshes in general position meet, by CGAL::Polygon_mesh_processing::surface_intersection.
curves curves_of(std::span<const float> points_a, std::span<const std::uint32_t> index_a,
                 std::span<const float> points_b, std::span<const std::uint32_t> index_b);

} // namespace meetc::cgal_test

#endif
