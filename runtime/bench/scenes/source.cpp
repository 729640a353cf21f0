#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/bench/scenes/scenes.hpp"
#include "meet/io/read.hpp"

#include <fmt/format.h>

namespace meetc::bench {

namespace {

io::element_set finer(const catalogue &all, const io::element_set &set, std::size_t least) {
  bodies::mesh m{set.data, set.index};
  while (m.triangles() < least)
    m = bodies::subdivide(m);
  return app::of_mesh(all, std::move(m));
}

} // namespace

io::element_set scene_source::read(const char *file, const io::transform &move) const {
  io::element_set set = io::read(*data / file, app::kinds_of(all), move);
  if (!app::is_mesh(set) || set.elements == 0)
    throw app::failure(fmt::format("{}: holds no triangles", (*data / file).string()));
  set.owner.clear();
  set.items = set.elements;
  return set;
}

io::element_set scene_source::body() const {
  return data ? read(quick ? "bunny_5k.ply" : "bunny_69k.ply") : app::of_mesh(all, bodies::blob(quick ? 48 : 90));
}

io::element_set scene_source::figure() const {
  io::transform near;
  if (data) {
    near.scale = 0.001;
    near.translate = {0, 0.1, 0};
    return read(quick ? "armadillo_5k.ply" : "armadillo_345k.ply", near);
  }
  near.translate = {0.4, 0, 0};
  return app::of_mesh(all, bodies::figure(quick ? 48 : 220), near);
}

io::element_set scene_source::finer_body(std::size_t least) const {
  return finer(all, body(), least);
}

io::element_set scene_source::finer_figure(std::size_t least) const {
  return finer(all, figure(), least);
}

} // namespace meetc::bench
