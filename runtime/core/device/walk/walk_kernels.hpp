// core/device/walk/walk_kernels.hpp: the kernels of hierarchies that depend on no kind of element. They only enqueue work.
#ifndef MEETC_CORE_DEVICE_WALK_WALK_KERNELS_HPP
#define MEETC_CORE_DEVICE_WALK_WALK_KERNELS_HPP

#include "meet/core/hierarchy/two_points.hpp"
#include "meetc/cuda/table.hpp"
#include "meetc/volume/tree.hpp"

namespace meetc {

// A walk of all elements of one set down the tree of another.
struct tree_walk {
  cuda::tree_view walker, tree;
  cuda::part of; // of the nodes of level 0: `a` of the walker's, `b` of the tree's
  bool swapped;  // the walker's elements are the second of each pair
  bool half; // the walker is the tree, and of two pairs that differ only in their order the one with a <= b is taken
  // The rows of the walker and where their two points are, if long elements are to be tested by those; else null.
  const float *rows;
  int fields;
  point_fields points;
  cuda::pair_list out; // pairs of slots; once it is full the walk stops early, and the count may leave pairs out. If
                       // they go there both ways, `rows` is null and the walker is the tree
  unsigned long long *taken; // 0 at first
  // Where one of these, of the walker and of the tree, says that a set is not in order, nothing is done. Null: it is.
  const cuda::order_findings *found_walker = nullptr, *found_tree = nullptr;
  // Both sets are of balls, which are compared by their boxes (core/hierarchy/two_balls.hpp). `out` has the pairs that are
  // proved to touch; without a list they are counted, and beyond its capacity the walk stops early too. `unsure` has those
  // whose boxes touch and that are not proved to be apart either, one way; once it is full the walk stops early. *near
  // becomes the number of both, each both ways if `out` has them both ways.
  bool balls = false;
  cuda::pair_list unsure{};
  unsigned long long *near = nullptr;

  MEETC_HD bool is_to_be_done() const {
    return (!found_walker || is_order(*found_walker, walker.elements)) &&
           (!found_tree || is_order(*found_tree, tree.elements));
  }
};
// Appends the pairs of slots whose boxes touch, except for long elements that by their two points are apart from the
// other's box, and for balls.
cudaError_t walk(const tree_walk &w, cudaStream_t stream);

} // namespace meetc

#endif
