// bench/scenes/cpu_sets.hpp: the sets that `meet bench cpu` measures.
//
// A middle body (69,451 triangles) and a large one (345,944), from files or built in, and segments and balls that go with
// them. All are made again for each family, so none keeps memory that another needs.
#ifndef MEETC_BENCH_SCENES_CPU_SETS_HPP
#define MEETC_BENCH_SCENES_CPU_SETS_HPP

#include "meet/bench/scenes/scenes.hpp"

#include <string>

namespace meetc::bench {

class cpu_sets {
public:
  // Throws io::error where the folder lacks bunny_69k.ply or armadillo_345k.ply (quick: bunny_5k.ply or
  // armadillo_5k.ply).
  explicit cpu_sets(const scene_source &from);

  // The middle body reaches into the large one. Both are scaled, then moved by `shift` along each axis.
  two_sets middle_in_large(double scale = 1, double shift = 0) const;
  two_sets segments_in_large() const; // segments as long as the box
  io::element_set large(const io::transform &move = {}) const;
  two_sets balls() const, many_balls() const; // in the cube [-1, 1)^3

  const char *middle_name() const { return from_.data ? "bunny" : "animal"; }
  const char *large_name() const { return from_.data ? "armadillo" : "figure"; }
  std::string in_words() const;

private:
  const scene_source from_;
};

} // namespace meetc::bench

#endif
