// bench/scenes/scenes.hpp: scenes: two sets and the predicate that is asked of them, made when they are measured.
#ifndef MEETC_BENCH_SCENES_SCENES_HPP
#define MEETC_BENCH_SCENES_SCENES_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/transform.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meetc::bench {

using two_sets = std::pair<io::element_set, io::element_set>;

struct scene {
  std::string name, predicate;
  std::function<two_sets()> make; // the predicate's first and second set
  bool itself = false;            // the second set is the first
  bool even = false;              // what the scenes after it are compared with
};

// Where bodies come from: a folder of meshes, or built-in bodies of about the same sizes; small ones where `quick`.
struct scene_source {
  const catalogue &all;
  std::optional<std::filesystem::path> data;
  bool quick;

  // A mesh of the folder, polygons as the triangles that they were cut into. Throws io::error where it is missing or holds
  // no triangles.
  io::element_set read(const char *file, const io::transform &move = {}) const;
  io::element_set body() const; // bunny_69k.ply (bunny_5k.ply), or an animal
  io::element_set
  figure() const; // armadillo_345k.ply (armadillo_5k.ply), or a figure, in a pose in which body reaches into it
  io::element_set finer_body(std::size_t least) const;   // cut until it has as many triangles
  io::element_set finer_figure(std::size_t least) const; // likewise
  const char *name_of_body() const { return data ? "Bunny" : "animal (built in)"; }
  const char *name_of_figure() const { return data ? "Armadillo" : "figure (built in)"; }
};

// Balls, meshes and segments of the sizes at which kernels are measured alone.
std::vector<scene> kernel_scenes(const scene_source &from);

// Scenes of growing size: about 1.1 pairs a ball, meshes, and segments as long as a mesh.
std::vector<scene> growth_scenes(const scene_source &from);

// A million elements that lie evenly, and as many that do not: far ones, clusters, sizes of many scales, copies.
std::vector<scene> hard_scenes(const scene_source &from);

// Segments as long as a mesh, of which it is asked what they meet first.
std::vector<scene> first_scenes(const scene_source &from);

// Two meshes that cross along a curve, finer ones, and segments and a mesh.
std::vector<scene> contact_scenes(const scene_source &from);

// Meshes with themselves.
std::vector<scene> self_scenes(const scene_source &from);

// Scenes for several devices: balls of growing number, meshes in either order, a mesh with itself, and many segments.
std::vector<scene> group_scenes(const scene_source &from);

// Balls of which a share of all pairs touches in exactly one point, which no bound in fp32 can decide.
std::vector<scene> tangent_scenes(const scene_source &from);

// A small mesh (bunny_5k.ply, or bunny_1k.ply) that is posed about a large one.
struct posed_meshes {
  io::element_set large, small;
  std::size_t poses;
};
posed_meshes meshes_for_poses(const scene_source &from);

} // namespace meetc::bench

#endif
