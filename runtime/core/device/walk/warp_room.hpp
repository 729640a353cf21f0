// core/device/walk/warp_room.hpp: what a warp of a walk has in shared memory, and what its lanes know of boxes.
#ifndef MEETC_CORE_DEVICE_WALK_WARP_ROOM_HPP
#define MEETC_CORE_DEVICE_WALK_WARP_ROOM_HPP

#include "meet/core/device/walk/hit_buffer.hpp"
#include "meet/core/device/walk/packet_cells.hpp"
#include "meet/core/hierarchy/two_points.hpp"
#include "meetc/volume/tree.hpp"

namespace meetc::cuda {

inline constexpr unsigned walk_threads = 128, walk_warps = walk_threads / tree_width;
// The children of its nodes have boxes of 1024 elements. To it, so many packets at least go down together first.
inline constexpr int coarse_level = 2;
inline constexpr unsigned least_together = 4;
// Fewer than 32 boxes wait before two leaves are looked at, each of which adds 32 at most.
inline constexpr unsigned waiting_size = 3 * tree_width;

// The room of one warp, in shared memory.
struct warp_room {
  // Boxes of the tree's elements that wait: the ends of each axis together, and in z.z the bits of their slots. Balls that are
  // tested lie in the place of their boxes: `least` in z.w, the rest in xy.
  float4 xy[waiting_size], z[waiting_size];
  packet_cells in_packet;     // of the packet that goes down
  cell_box cells[tree_width]; // of those that are tested
  index_pair hits[hits_size];
  // Nodes that some of the items touch which go down together, and these items as bits.
  std::uint32_t near[tree_width], near_items[tree_width];
};

__device__ inline float longest_side(const tree_box &b) {
  return fmaxf(fmaxf(b.high[0] - b.low[0], b.high[1] - b.low[1]), b.high[2] - b.low[2]);
}
// Half of the area of its faces; 0 if it is empty.
__device__ inline float half_area(const tree_box &b) {
  const float x = b.high[0] - b.low[0], y = b.high[1] - b.low[1], z = b.high[2] - b.low[2];
  return x >= 0 ? x * y + y * z + z * x : 0;
}
__device__ inline tree_box from_lane(const tree_box &b, unsigned lane) {
  tree_box out;
  for (int k = 0; k < 3; ++k)
    out.low[k] = __shfl_sync(~0U, b.low[k], lane), out.high[k] = __shfl_sync(~0U, b.high[k], lane);
  return out;
}
__device__ inline two_points from_lane(const two_points &t, unsigned lane) {
  two_points out;
  for (int k = 0; k < 3; ++k) {
    out.enter[k] = __shfl_sync(~0U, t.enter[k], lane);
    out.leave[k] = __shfl_sync(~0U, t.leave[k], lane);
    out.per[k] = __shfl_sync(~0U, t.per[k], lane);
  }
  return out;
}

// The nodes that a warp on its way down has still to enter. Each lane keeps those of one level. All functions are of
// the whole warp.
class nodes_to_enter {
public:
  // These children of a node of this level.
  __device__ void enter(int level, std::uint32_t node, unsigned children) {
    if (lane() == level)
      node_ = node, left_ = children;
  }
  // The next child of the lowest level above this one, up to `top`, that has one left. Returns false where none has.
  __device__ bool next(int top, int &level, std::uint32_t &node) {
    const unsigned levels = (2U << top) - (2U << level);
    const unsigned have = __ballot_sync(~0U, left_ != 0) & levels;
    if (have == 0)
      return false;
    level = __ffs(have) - 1;
    const unsigned left = __shfl_sync(~0U, left_, level);
    node = __shfl_sync(~0U, node_, level) * tree_width + __ffs(left) - 1;
    if (lane() == level)
      left_ = left & (left - 1);
    --level;
    return true;
  }

private:
  __device__ static int lane() { return static_cast<int>(threadIdx.x % tree_width); }
  std::uint32_t node_ = 0, left_ = 0; // of this lane's level the node, and its lanes still to be entered
};

} // namespace meetc::cuda

#endif
