// core/hierarchy/hierarchy.hpp: boxes in blocks of sixteen, and boxes around blocks, up to one block.
//
// Level 0 holds the element boxes in spatial order; box i of level k+1 encloses block i of level k. There are no
// pointers: the children of box i are block i of the level below. A set that is not empty has a level 1, and the top
// level is one block.
#ifndef MEETC_CORE_HIERARCHY_HIERARCHY_HPP
#define MEETC_CORE_HIERARCHY_HIERARCHY_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/memory.hpp"

namespace meetc {

struct level {
  box_block *blocks = nullptr;
  std::size_t boxes = 0;
  double widths[3] = {0, 0, 0}; // the sums of the widths of all boxes

  std::size_t count() const { return (boxes + lanes - 1) / lanes; }
  std::size_t filled(std::size_t block) const { return std::min<std::size_t>(lanes, boxes - block * lanes); }
  box get(std::size_t i) const { return blocks[i / lanes].get(static_cast<int>(i % lanes)); }
};

struct hierarchy {
  level levels[9]; // 16^8 = 2^32 elements
  int depth = 0;   // levels in use; 0 for the empty set

  const level &top() const { return levels[depth - 1]; }
};

// The levels over n elements, with their blocks from the allocator.
hierarchy take_hierarchy(bump_allocator &from, std::size_t n);

// Makes it the hierarchy over n elements, at most as many as its blocks were taken for.
void resize(hierarchy &h, std::size_t n);

// Adds the widths of the first `filled` boxes in a block.
void add_widths(const box_block &block, std::size_t filled, double widths[3]);

// Fills every level above level 0, and the sums of all widths. The blocks of level 0 must be full or end in empty
// lanes.
void enclose(hierarchy &h, const execution &on);

} // namespace meetc

#endif
