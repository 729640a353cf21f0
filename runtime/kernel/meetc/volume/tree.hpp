// The bounding volume hierarchy over a set on a device, as kernels and their stand-in on a host see it.
//
// The elements are in a spatial order. Every 32 consecutive ones have a node with their boxes, every 32 nodes a node
// above with the boxes around theirs, and so on up to one root. There are no pointers: the children of lane i of node n
// are in node 32 n + i of the level below. A warp tests a node at once, one lane a box.
//
// Boxes are finite: an end beyond float32 becomes its largest number, which loses no pair, since clamping is monotone.
// An empty lane, from +inf to -inf, touches none of them.
#ifndef MEETC_VOLUME_TREE_HPP
#define MEETC_VOLUME_TREE_HPP

#include <meetc/table/table.hpp>

#include <cfloat>
#include <cmath>

namespace meetc::cuda {

inline constexpr std::uint32_t tree_width = 32;
inline constexpr int tree_levels = 7; // 32^7 > 2^32 elements

struct tree_node {
  struct alignas(8) ends {
    float low, high;
  };
  ends of[3][tree_width]; // by axes, of each lane
};

// The places of the levels in an array of nodes. Level 0 has the elements' boxes. A tree has at least two levels, and
// its last is the root; a tree without elements has no level.
struct tree_shape {
  std::uint32_t first[tree_levels] = {}, count[tree_levels] = {}; // nodes
  int depth = 0;

  tree_shape() = default;
  MEETC_HD constexpr explicit tree_shape(std::uint32_t elements) {
    std::uint32_t boxes = elements, at = 0;
    while (boxes > 0 && (depth < 2 || boxes > 1)) {
      boxes = boxes / tree_width + (boxes % tree_width != 0);
      first[depth] = at, count[depth] = boxes;
      at += boxes;
      ++depth;
    }
  }
  MEETC_HD constexpr std::uint32_t nodes() const { return depth == 0 ? 0 : first[depth - 1] + 1; }
};

// The number of levels that the kernel for the elements' boxes fills: all levels of a small set, since every further
// kernel costs a launch.
MEETC_HD constexpr int levels_with_boxes(std::uint32_t elements) {
  return elements <= std::uint32_t{1} << 20 ? 4 : 2;
}

// A tree in device memory. Lane i of node n of level 0 is element 32 n + i of the rows.
struct tree_view {
  const tree_node *nodes;
  std::uint32_t elements;
  tree_shape shape;
};

struct tree_box {
  float low[3] = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high[3] = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}; // empty

  MEETC_HD void widen(const tree_box &b) {
    for (int k = 0; k < 3; ++k) {
      low[k] = b.low[k] < low[k] ? b.low[k] : low[k];
      high[k] = high[k] < b.high[k] ? b.high[k] : high[k];
    }
  }
  MEETC_HD bool touches(const tree_box &b) const {
    bool apart = false;
    for (int k = 0; k < 3; ++k)
      apart |= (low[k] > b.high[k]) | (b.low[k] > high[k]);
    return !apart;
  }
};

MEETC_HD inline tree_box box_of(const tree_node &n, std::uint32_t lane) {
  tree_box b;
  for (int k = 0; k < 3; ++k)
    b.low[k] = n.of[k][lane].low, b.high[k] = n.of[k][lane].high;
  return b;
}
MEETC_HD inline void put_box(tree_node &n, std::uint32_t lane, const tree_box &b) {
  for (int k = 0; k < 3; ++k)
    n.of[k][lane] = {b.low[k], b.high[k]};
}

// The finite box of a row; NaN becomes an end of float32, so that along that axis the box meets every other.
template <class Shape> MEETC_HD inline tree_box box_of_row(const float *row) {
  tree_box b;
  Shape::box(row, b.low, b.high);
  for (int k = 0; k < 3; ++k) {
    b.low[k] = b.low[k] > -FLT_MAX ? b.low[k] : -FLT_MAX, b.low[k] = b.low[k] < FLT_MAX ? b.low[k] : FLT_MAX;
    b.high[k] = b.high[k] < FLT_MAX ? b.high[k] : FLT_MAX, b.high[k] = b.high[k] > -FLT_MAX ? b.high[k] : -FLT_MAX;
  }
  return b;
}

} // namespace meetc::cuda

#endif
