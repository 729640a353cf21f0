#include "tests/cgal/self_judge.hpp"

#include <algorithm>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <iterator>

namespace meetc::cgal_test {

std::optional<pair_list> self_intersections(const std::vector<float> &xyz, const std::vector<std::uint32_t> &index) {
  using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using surface = CGAL::Surface_mesh<kernel::Point_3>;
  surface mesh;
  std::vector<surface::Vertex_index> vertices;
  for (std::size_t i = 0; i < xyz.size(); i += 3)
    vertices.push_back(mesh.add_vertex(
        {static_cast<double>(xyz[i]), static_cast<double>(xyz[i + 1]), static_cast<double>(xyz[i + 2])}));
  for (std::size_t i = 0; i < index.size(); i += 3)
    if (mesh.add_face(vertices[index[i]], vertices[index[i + 1]], vertices[index[i + 2]]) == surface::null_face())
      return std::nullopt;
  std::vector<std::pair<surface::Face_index, surface::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  pair_list out;
  for (const auto &[f, g] : found)
    if (f != g) // a face without area comes as (f, f)
      out.emplace_back(std::min<std::uint32_t>(f, g), std::max<std::uint32_t>(f, g));
  std::sort(out.begin(), out.end());
  return out;
}

} // namespace meetc::cgal_test
