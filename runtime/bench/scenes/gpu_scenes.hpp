// bench/scenes/gpu_scenes.hpp: the scenes that `meet bench gpu` measures.
#ifndef MEETC_BENCH_SCENES_GPU_SCENES_HPP
#define MEETC_BENCH_SCENES_GPU_SCENES_HPP

#include "io/element_set.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

struct gpu_scene {
  std::string name, predicate;
  std::function<std::pair<io::element_set, io::element_set>()> make; // the predicate's first and second set
  bool itself = false;                                               // the second set is the first
  bool even = false;                                                 // what the scenes after it are compared with
};

// Throws io::error where the folder lacks a mesh: bunny_69k.ply, armadillo_345k.ply.
std::vector<gpu_scene> gpu_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick);

// Scenes of growing size: about 1.1 pairs a ball, meshes, and segments as long as a mesh.
std::vector<gpu_scene> growth_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data,
                                     bool quick);

// A million elements that lie evenly, and as many that do not: far ones, clusters, sizes of many scales, copies.
std::vector<gpu_scene> hard_scenes(const catalogue &all, bool quick);

// Segments as long as a mesh, of which it is asked what they meet first.
std::vector<gpu_scene> first_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick);

// Scenes for several devices: balls of growing number, meshes in either order, a mesh with itself, and many segments.
std::vector<gpu_scene> group_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick);

// A small mesh that is posed about a large one.
struct posed_meshes {
  io::element_set large, small;
  std::size_t poses;
};
// Throws io::error where the folder lacks a mesh: bunny_5k.ply, armadillo_345k.ply.
posed_meshes meshes_for_poses(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick);

// Balls of which a share of all pairs touches in exactly one point, which no bound in fp32 can decide.
struct tangent_scene {
  std::string name;
  io::element_set a, b;
};
std::vector<std::function<tangent_scene()>> tangent_scenes(const catalogue &all, bool quick);

} // namespace meetc::bench

#endif
