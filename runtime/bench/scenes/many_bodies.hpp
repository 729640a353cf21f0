// bench/scenes/many_bodies.hpp: many bodies of one shape, which all move.
#ifndef MEETC_BENCH_SCENES_MANY_BODIES_HPP
#define MEETC_BENCH_SCENES_MANY_BODIES_HPP

#include "meet/bodies/meshes.hpp"
#include "meet/core/world/world.hpp"

#include <memory>
#include <random>

namespace meetc::bench {

// Tori of 5,000 triangles, in a cube in which some of them touch. Each turns about y by a quarter turn at most.
class many_bodies {
public:
  many_bodies(const catalogue &all, std::size_t count, int threads);

  view faces() const { return {shape_.xyz.data(), shape_.vertices(), 0, shape_.index.data(), shape_.triangles()}; }
  const kind_info &kind() const { return own_->kind(); }
  const world &bodies() const { return bodies_; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(bodies_.size()); }
  // Gives each body its next pose.
  void move_all();

private:
  bodies::mesh shape_;
  std::shared_ptr<const prepared> own_;
  world bodies_;
  double range_;
  std::mt19937 random_{1};

  pose drawn();
};

// A pair of bodies for each pair of their elements.
std::vector<index_pair> touching_pairs(const world_answer &found);

} // namespace meetc::bench

#endif
