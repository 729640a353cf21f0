#include "meet/bench/scenes/cpu_sets.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/bench/scenes/scene_sets.hpp"

#include <fmt/format.h>

namespace meetc::bench {

namespace {

// The pose in which the middle body reaches into the large one: scale, then a move.
struct pose_of_middle {
  double scale, x, y, z;
};

} // namespace

cpu_sets::cpu_sets(const scene_source &from) : from_(from) {
  if (from_.data && !std::filesystem::is_directory(*from_.data))
    throw app::failure(fmt::format("--data {}: is not a folder", from_.data->string()));
}

io::element_set cpu_sets::large(const io::transform &move) const {
  if (from_.data)
    return from_.read(from_.quick ? "armadillo_5k.ply" : "armadillo_345k.ply", move);
  return app::of_mesh(from_.all, from_.quick ? bodies::knot(100, 25) : bodies::figure(220), move);
}

two_sets cpu_sets::middle_in_large(double scale, double shift) const {
  const pose_of_middle at = from_.data    ? pose_of_middle{1000, 0, -100, 0}
                            : from_.quick ? pose_of_middle{1, 0, 0, 0}
                                          : pose_of_middle{1, -0.4, 0, 0};
  io::transform middle, large_body;
  if (from_.data || scale != 1 || shift != 0 || at.x != 0) {
    middle.scale = at.scale * scale;
    middle.translate = {at.x * scale + shift, at.y * scale + shift, at.z * scale + shift};
  }
  if (scale != 1 || shift != 0) {
    large_body.scale = scale;
    large_body.translate = {shift, shift, shift};
  }
  if (from_.data)
    return {from_.read(from_.quick ? "bunny_5k.ply" : "bunny_69k.ply", middle), large(large_body)};
  return {app::of_mesh(from_.all, from_.quick ? bodies::torus(40, 25) : bodies::blob(90), middle), large(large_body)};
}

two_sets cpu_sets::segments_in_large() const {
  io::element_set mesh = large();
  io::element_set segments = segments_in(from_.all, mesh, from_.quick ? 100 : 10'000, 1);
  return {std::move(segments), std::move(mesh)};
}

// Two clouds of n balls. About 4.3 r^3 of all pairs touch: 4 in a million for r = 0.0098, and 4.4 million of those of two
// clouds of 4 million for r = 0.004.
static two_sets clouds(const catalogue &all, std::size_t n, double radius) {
  return {ball_cloud(all, n, 1, radius), ball_cloud(all, n, 2, radius)};
}

two_sets cpu_sets::balls() const {
  return from_.quick ? clouds(from_.all, 2000, 0.05) : clouds(from_.all, 262'144, 0.0098);
}

two_sets cpu_sets::many_balls() const {
  return from_.quick ? clouds(from_.all, 4000, 0.04) : clouds(from_.all, 4'000'000, 0.004);
}

std::string cpu_sets::in_words() const {
  if (from_.data)
    return from_.quick ? "The meshes are bunny_5k.ply and armadillo_5k.ply."
                       : "The meshes are bunny_69k.ply and armadillo_345k.ply.";
  return from_.quick ? "The meshes are built in: a ring and a knot, small."
                     : "The meshes are built in: an animal and a figure.";
}

} // namespace meetc::bench
