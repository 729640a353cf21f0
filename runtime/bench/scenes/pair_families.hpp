// bench/scenes/pair_families.hpp: pairs of triangles whose exact decisions are hard in different ways.
#ifndef MEETC_BENCH_SCENES_PAIR_FAMILIES_HPP
#define MEETC_BENCH_SCENES_PAIR_FAMILIES_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace meetc::bench {

struct pair_family {
  std::string name;
  std::vector<float> a, b; // rows of 9 floats; pair i is row i with row i
  std::size_t pairs() const { return a.size() / 9; }
};

// Each family has n pairs of triangles that have an area and whose boxes touch; the same on every machine.
//
// random:            corners uniform in the cube [-1, 1)^3
// a shared corner:   the same, with one corner of b equal to one of a
// a shared edge:     two corners
// oblique coplanar:  corners on the plane of two random integer vectors, exactly
// on a plane, 1, 3:  one corner of b, or all, computed on a's plane in double and rounded to float
std::vector<pair_family> pair_families(std::size_t n);

} // namespace meetc::bench

#endif
