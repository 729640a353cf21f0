#include "app/demo_scenes.hpp"

#include "app/failure.hpp"
#include "app/meshes.hpp"
#include "io/transform.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace meet::app {

namespace {

const kind_info &kind_named(const catalogue &all, std::string_view name) {
  for (int i = 0; i < all.kind_count; ++i)
    if (all.kinds[i].name == name)
      return all.kinds[i];
  throw failure(fmt::format("this build has no kind '{}'", name));
}

io::element_set of_mesh(const catalogue &all, mesh m, const io::transform &move = {}) {
  for (std::size_t v = 0; v < m.xyz.size(); v += 3) {
    const auto p = io::round_point(move, {m.xyz[v], m.xyz[v + 1], m.xyz[v + 2]});
    m.xyz[v] = p[0];
    m.xyz[v + 1] = p[1];
    m.xyz[v + 2] = p[2];
  }
  io::element_set set;
  set.kind = &kind_named(all, "triangle");
  set.vertices = m.vertices();
  set.elements = set.items = m.triangles();
  set.data = std::move(m.xyz);
  set.index = std::move(m.index);
  return set;
}

io::element_set of_rows(const catalogue &all, std::string_view kind, std::vector<float> rows) {
  io::element_set set;
  set.kind = &kind_named(all, kind);
  set.elements = set.items = rows.size() / static_cast<std::size_t>(set.kind->fields);
  set.data = std::move(rows);
  return set;
}

io::transform moved(double x, double y, double z, double scale = 1) {
  io::transform t;
  t.scale = scale;
  t.translate = {x, y, z};
  return t;
}

} // namespace

std::vector<demo_scene> demo_scenes(const catalogue &all) {
  std::vector<demo_scene> out;
  out.push_back({"animal-figure", "animal", "figure", of_mesh(all, blob(96)),
                 of_mesh(all, figure(96), moved(0.75, 0.25, 0.25))});
  out.push_back({"knot-rods", "knot", "rods", of_mesh(all, knot(720, 36)),
                 of_rows(all, "segment", segment_cloud(1200, 7, 0.25))});
  out.push_back({"gear-balls", "gear", "balls", of_mesh(all, gear(24, 4)),
                 of_rows(all, "sphere", sphere_cloud(600, 11, 0.02, 0.08))});
  out.push_back({"balls-balls", "balls", "more balls",
                 of_rows(all, "sphere", sphere_cloud(400, 13, 0.02, 0.08)),
                 of_rows(all, "sphere", sphere_cloud(400, 17, 0.02, 0.08))});
  return out;
}

} // namespace meet::app
