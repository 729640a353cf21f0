// bench/scenes/scene_sets.hpp: sets of elements that several scenes of the benchmarks use.
#ifndef MEETC_BENCH_SCENES_SCENE_SETS_HPP
#define MEETC_BENCH_SCENES_SCENE_SETS_HPP

#include "meet/io/elements/element_set.hpp"
#include "meetc/support.hpp"

#include <cstdint>

namespace meetc::bench {

// Balls in the cube [-1, 1)^3 with radii from 0.8 to 1.2 of `radius`.
io::element_set ball_cloud(const catalogue &all, std::size_t n, std::uint64_t seed, double radius);

// Boxes of this half-width about points of the cube [0, 1)^3.
io::element_set box_cloud(const catalogue &all, std::size_t n, std::uint64_t seed, double half_width);

// The box around the coordinates of an indexed mesh, in double.
struct mesh_extent {
  double lo[3], hi[3];
  double longest() const;
};
mesh_extent extent_of(const io::element_set &mesh);

// Segments whose length is a share of the box's longest side, spread over the box of the mesh.
io::element_set segments_in(const catalogue &all, const io::element_set &mesh, std::size_t n, double share);

} // namespace meetc::bench

#endif
