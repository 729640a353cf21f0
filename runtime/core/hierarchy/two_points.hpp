// core/hierarchy/two_points.hpp: the test of an element whose hull has two points against sixteen boxes at once. The test
// and its proof are in meetc/volume/two_points.hpp.
#ifndef MEETC_CORE_HIERARCHY_TWO_POINTS_HPP
#define MEETC_CORE_HIERARCHY_TWO_POINTS_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meetc/volume/two_points.hpp"

namespace meetc {

// Whether the candidates of this kind are to be tested by their two points.
inline bool has_two_points(const kind_info &kind) {
  return kind.hull == 2;
}

// The kind has two points.
inline two_points two_points_of(const kind_info &kind, const float *row) {
  return two_points_of(point_fields_of(kind), row);
}

// Bit i is set where lane i of the block may touch the element. Lanes must be finite boxes; for others the answer means
// nothing.
inline std::uint32_t touching(const box_block &block, const two_points &t, parameter_margin margin = {}) {
  const float *first[3], *last[3];
  for (int k = 0; k < 3; ++k) {
    first[k] = t.per[k] < 0 ? block.hi[k] : block.lo[k];
    last[k] = t.per[k] < 0 ? block.lo[k] : block.hi[k];
  }
  std::uint32_t mask = 0;
  for (int i = 0; i < lanes; ++i)
    mask |= apart(t, {first[0][i], first[1][i], first[2][i]}, {last[0][i], last[1][i], last[2][i]}, margin)
                ? 0
                : lane_bit[i];
  return mask;
}

} // namespace meetc

#endif
