#include "tests/cgal/contacts_judge.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace meetc::cgal_test {
namespace {

using rationals = CGAL::Simple_cartesian<CGAL::Gmpq>;
using point = rationals::Point_3;
using segment = rationals::Segment_3;
using triangle = rationals::Triangle_3;

point point_at(const float *p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}
triangle triangle_at(const float *row) {
  return {point_at(row), point_at(row + 3), point_at(row + 6)};
}

struct corners_of {
  std::set<fraction_point> out;
  void operator()(const point &p) {
    fraction_point x;
    for (int k = 0; k < 3; ++k) {
      std::ostringstream num, den;
      num << p[k].numerator(), den << p[k].denominator();
      x[static_cast<std::size_t>(2 * k)] = num.str(), x[static_cast<std::size_t>(2 * k + 1)] = den.str();
    }
    out.insert(x);
  }
  void operator()(const segment &s) { (*this)(s.source()), (*this)(s.target()); }
  void operator()(const triangle &t) {
    for (int i = 0; i < 3; ++i)
      (*this)(t.vertex(i));
  }
  void operator()(const std::vector<point> &polygon) {
    for (const point &p : polygon)
      (*this)(p);
  }
};

template <class A> std::set<fraction_point> corners(const A &a, const triangle &b) {
  corners_of visitor;
  if (const auto common = CGAL::intersection(a, b))
    boost::apply_visitor([&visitor](const auto &x) { visitor(x); }, *common);
  return visitor.out;
}

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using mesh = CGAL::Surface_mesh<kernel::Point_3>;

mesh mesh_of(std::span<const float> points, std::span<const std::uint32_t> index) {
  mesh out;
  for (std::size_t i = 0; i < points.size(); i += 3)
    out.add_vertex(
        {static_cast<double>(points[i]), static_cast<double>(points[i + 1]), static_cast<double>(points[i + 2])});
  for (std::size_t i = 0; i < index.size(); i += 3)
    if (out.add_face(mesh::Vertex_index(index[i]), mesh::Vertex_index(index[i + 1]),
                     mesh::Vertex_index(index[i + 2])) == mesh::null_face())
      throw std::invalid_argument("the mesh is not manifold");
  return out;
}

} // namespace

std::optional<std::set<fraction_point>> common_points(const float *a, int corners_a, const float *b) {
  const triangle second = triangle_at(b);
  if (second.is_degenerate())
    return std::nullopt;
  if (corners_a == 2) {
    const segment first(point_at(a), point_at(a + 3));
    return first.is_degenerate() ? std::nullopt : std::optional(corners(first, second));
  }
  const triangle first = triangle_at(a);
  return first.is_degenerate() ? std::nullopt : std::optional(corners(first, second));
}

curves curves_of(std::span<const float> points_a, std::span<const std::uint32_t> index_a,
                 std::span<const float> points_b, std::span<const std::uint32_t> index_b) {
  mesh a = mesh_of(points_a, index_a), b = mesh_of(points_b, index_b);
  std::vector<std::vector<kernel::Point_3>> lines;
  CGAL::Polygon_mesh_processing::surface_intersection(a, b, std::back_inserter(lines));
  curves out;
  std::set<kernel::Point_3> nodes;
  for (const auto &line : lines) {
    nodes.insert(line.begin(), line.end());
    out.closed += line.front() == line.back();
  }
  out.nodes = nodes.size();
  out.polylines = lines.size();
  return out;
}

} // namespace meetc::cgal_test
