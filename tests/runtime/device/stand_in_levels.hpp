// The levels of a tree on the host: see stand_in.cpp.
#pragma once
#include <meetc/tree.hpp>

namespace meetc::cuda {

// Fills the level above one, its empty lanes too.
inline void enclose_level(tree_node *nodes, const tree_shape &shape, int level) {
  for (std::uint32_t node = 0; node < shape.count[level + 1] * tree_width; ++node) {
    tree_box b;
    for (std::uint32_t lane = 0; node < shape.count[level] && lane < tree_width; ++lane)
      b.widen(box_of(nodes[shape.first[level] + node], lane));
    put_box(nodes[shape.first[level + 1] + node / tree_width], node % tree_width, b);
  }
}

} // namespace meetc::cuda
