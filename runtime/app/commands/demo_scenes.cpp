#include "meet/app/commands/demo_scenes.hpp"

#include "meet/app/input/made_sets.hpp"

namespace meetc::app {

namespace {

io::transform moved(double x, double y, double z, double scale = 1) {
  io::transform t;
  t.scale = scale;
  t.translate = {x, y, z};
  return t;
}

} // namespace

std::vector<demo_scene> demo_scenes(const catalogue &all) {
  std::vector<demo_scene> out;
  out.push_back({"animal-figure", "animal", "figure", of_mesh(all, bodies::blob(96)),
                 of_mesh(all, bodies::figure(96), moved(0.75, 0.25, 0.25))});
  out.push_back({"knot-rods", "knot", "rods", of_mesh(all, bodies::knot(720, 36)),
                 of_rows(all, "segment", bodies::segment_cloud(1200, 7, 0.25))});
  out.push_back({"gear-balls", "gear", "balls", of_mesh(all, bodies::gear(24, 4)),
                 of_rows(all, "sphere", bodies::sphere_cloud(600, 11, 0.02, 0.08))});
  out.push_back({"balls-balls", "balls", "more balls",
                 of_rows(all, "sphere", bodies::sphere_cloud(400, 13, 0.02, 0.08)),
                 of_rows(all, "sphere", bodies::sphere_cloud(400, 17, 0.02, 0.08))});
  return out;
}

} // namespace meetc::app
