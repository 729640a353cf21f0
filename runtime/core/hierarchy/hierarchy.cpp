#include "meet/core/hierarchy/hierarchy.hpp"

#include "meet/core/threads/threads.hpp"

#include <mutex>

namespace meetc {

void resize(hierarchy &h, std::size_t n) {
  h.depth = 0;
  for (level &l : h.levels)
    l.boxes = 0;
  for (std::size_t boxes = n; boxes > 0; boxes = h.top().count()) {
    h.levels[h.depth++].boxes = boxes;
    if (h.depth > 1 && boxes <= lanes)
      break;
  }
}

hierarchy take_hierarchy(bump_allocator &from, std::size_t n) {
  hierarchy h;
  resize(h, n);
  for (int k = 0; k < h.depth; ++k)
    h.levels[k].blocks = from.take<box_block>(h.levels[k].count());
  return h;
}

void add_widths(const box_block &block, std::size_t filled, double widths[3]) {
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < filled; ++i)
      widths[k] += static_cast<double>(block.hi[k][i]) - static_cast<double>(block.lo[k][i]);
}

void enclose(hierarchy &h, int threads) {
  std::mutex lock;
  for (int k = 0; k < h.depth; ++k) {
    level &here = h.levels[k];
    std::fill_n(here.widths, 3, 0.0);
    for_chunks(threads, here.count(), 256, [&](int, std::size_t begin, std::size_t end) {
      double widths[3] = {0, 0, 0};
      for (std::size_t i = begin; i < end; ++i) {
        if (k > 0) {
          const level &below = h.levels[k - 1];
          here.blocks[i].clear();
          for (std::size_t child = i * lanes; child < std::min(here.boxes, (i + 1) * lanes); ++child)
            here.blocks[i].set(static_cast<int>(child % lanes), below.blocks[child].around());
        }
        add_widths(here.blocks[i], here.filled(i), widths);
      }
      const std::scoped_lock hold(lock);
      for (int axis = 0; axis < 3; ++axis)
        here.widths[axis] += widths[axis];
    });
  }
}

} // namespace meetc
