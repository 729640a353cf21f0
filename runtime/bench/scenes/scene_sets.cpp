#include "meet/bench/scenes/scene_sets.hpp"

#include "meet/app/input/made_sets.hpp"

#include <cmath>
#include <utility>

namespace meetc::bench {

io::element_set ball_cloud(const catalogue &all, std::size_t n, std::uint64_t seed, double radius) {
  return app::of_rows(all, "sphere", bodies::sphere_cloud(n, seed, 0.8 * radius, 1.2 * radius));
}

io::element_set box_cloud(const catalogue &all, std::size_t n, std::uint64_t seed, double half_width) {
  const std::vector<float> centres = bodies::sphere_cloud(n, seed, 0, 0);
  std::vector<float> rows;
  rows.reserve(6 * n);
  for (std::size_t i = 0; i < n; ++i)
    for (const double way : {-half_width, half_width})
      for (std::size_t k = 0; k < 3; ++k)
        rows.push_back(static_cast<float>((static_cast<double>(centres[4 * i + k]) + 1) / 2 + way));
  return app::of_rows(all, "box", std::move(rows));
}

double mesh_extent::longest() const {
  return std::fmax(hi[0] - lo[0], std::fmax(hi[1] - lo[1], hi[2] - lo[2]));
}

mesh_extent extent_of(const io::element_set &mesh) {
  mesh_extent e{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (std::size_t i = 0; i < mesh.data.size(); ++i) {
    e.lo[i % 3] = std::fmin(e.lo[i % 3], static_cast<double>(mesh.data[i]));
    e.hi[i % 3] = std::fmax(e.hi[i % 3], static_cast<double>(mesh.data[i]));
  }
  return e;
}

io::element_set segments_in(const catalogue &all, const io::element_set &mesh, std::size_t n, double share) {
  const mesh_extent e = extent_of(mesh);
  std::vector<float> rows =
      bodies::segment_cloud(n, 5, 2 * share); // in a cube of side 2 first, then scaled to one of side `longest`
  for (std::size_t i = 0; i < rows.size(); i += 6)
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = rows[i + k], q = rows[i + 3 + k], middle = (p + q) / 2, way = (q - p) / 2;
      const double at = (e.lo[k] + e.hi[k]) / 2 + middle * (e.hi[k] - e.lo[k]) / 2;
      rows[i + k] = static_cast<float>(at - way * e.longest() / 2);
      rows[i + 3 + k] = static_cast<float>(at + way * e.longest() / 2);
    }
  return app::of_rows(all, "segment", std::move(rows));
}

} // namespace meetc::bench
