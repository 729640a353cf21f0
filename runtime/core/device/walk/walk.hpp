// core/device/walk/walk.hpp: which set walks down the hierarchy of which, and what it lists.
#ifndef MEETC_CORE_DEVICE_WALK_WALK_HPP
#define MEETC_CORE_DEVICE_WALK_WALK_HPP

#include "meet/core/device/set/rows.hpp"
#include "meet/core/device/walk/walk_kernels.hpp"

namespace meetc {

enum class walk_lists : std::uint8_t {
  candidates, // pairs whose boxes touch
  hits,       // the same, where the predicate says no more
  balls,      // hits that the boxes of balls prove, and candidates
  first       // of what is met first: hits that are proved on the way, and candidates
};
// Only rungs that are never wrong take the proof for an answer.
walk_lists lists_of(const cuda::predicate_launchers &by, rung precision);

// The walk of two sets with elements, but for its part and its lists. Makes hierarchies where there are none; enqueues, and
// throws device_error. `half`: the two are one set, and of each pair of elements one order is looked at.
tree_walk walk_of(const device &on, device_rows &a, device_rows &b, rung precision, walk_lists what, bool half);

// The nodes with the elements' boxes, by which parts of a walk are counted.
std::uint32_t lowest_nodes(const device_rows &s);

} // namespace meetc

#endif
