// A hierarchy of boxes by fours over a set on a device, down which a thread can go alone.
//
// Problem: down the hierarchy of meetc/volume/tree.hpp a warp goes together, 32 boxes at once; where a single element goes
// down, most of the 32 are far from it. Method: every 4 consecutive elements have a node with their boxes, every 4 nodes a
// node above, up to one root, in the same order. There are no pointers: nodes are numbered from the root down, each level
// as if it were full, so that child c of node q has the number 4 q + 1 + c. Elements have the numbers behind those of the
// nodes of a full tree. A level's last places can be empty; no box of the level above leads there.
//
// Boxes are those of the other hierarchy, finite. An empty lane, from +inf to -inf, touches none of them.
#ifndef MEETC_VOLUME_FOURS_HPP
#define MEETC_VOLUME_FOURS_HPP

#include <meetc/volume/tree.hpp>

namespace meetc::cuda {

struct alignas(16) four_ends {
  float of[4];
};
struct four_boxes {
  four_ends of[3][2]; // by axes: the low ends, and the high ends
};

// More elements than these have no such tree, so that numbers have 32 bits.
inline constexpr std::uint32_t most_in_fours = std::uint32_t{1} << 30;
inline constexpr int fours_levels = 15;

struct fours_shape {
  std::uint32_t elements = 0;
  int depth = 0; // levels of nodes

  fours_shape() = default;
  // From 1 to most_in_fours elements.
  MEETC_HD constexpr explicit fours_shape(std::uint32_t n) : elements(n), depth(1) {
    while (depth < fours_levels && std::uint64_t{1} << 2 * depth < n)
      ++depth;
  }
  // The number of the first node of a level; level 0 is the root, and level `depth` has the elements.
  MEETC_HD static constexpr std::uint32_t first(int level) {
    return static_cast<std::uint32_t>(((std::uint64_t{1} << 2 * level) - 1) / 3);
  }
  // The nodes of a level that have elements below them.
  MEETC_HD constexpr std::uint32_t count(int level) const { return ((elements - 1) >> 2 * (depth - level)) + 1; }
  MEETC_HD constexpr std::uint32_t first_element() const { return first(depth); }
  // Places for nodes.
  MEETC_HD constexpr std::uint32_t nodes() const { return first(depth - 1) + count(depth - 1); }
};

// In device memory.
struct fours_view {
  const four_boxes *nodes;
  fours_shape shape;
};

MEETC_HD inline tree_box box_of(const four_boxes &n, unsigned lane) {
  tree_box b;
  for (int k = 0; k < 3; ++k)
    b.low[k] = n.of[k][0].of[lane], b.high[k] = n.of[k][1].of[lane];
  return b;
}
MEETC_HD inline void put_box(four_boxes &n, unsigned lane, const tree_box &b) {
  for (int k = 0; k < 3; ++k)
    n.of[k][0].of[lane] = b.low[k], n.of[k][1].of[lane] = b.high[k];
}

// The boxes of child nodes or elements of node q of a level, as far as there are any: those of the elements are in a tree,
// and the others are around the boxes of nodes that are there already.
MEETC_HD inline four_boxes made_node(const fours_shape &s, int level, std::uint32_t q, const tree_node *elements,
                                     const four_boxes *nodes) {
  four_boxes out;
  for (unsigned c = 0; c < 4; ++c) {
    const std::uint32_t child = 4 * q + c;
    tree_box b;
    if (level + 1 == s.depth) {
      if (child < s.elements)
        b = box_of(elements[child / tree_width], child % tree_width);
    } else if (child < s.count(level + 1)) {
      for (unsigned i = 0; i < 4; ++i)
        b.widen(box_of(nodes[fours_shape::first(level + 1) + child], i));
    }
    put_box(out, c, b);
  }
  return out;
}

} // namespace meetc::cuda

#endif
