#include "core/hierarchy.hpp"

#include "core/threads.hpp"

namespace meetc {

hierarchy take_hierarchy(bump_allocator &from, std::size_t n) {
  hierarchy h;
  for (std::size_t boxes = n; boxes > 0; boxes = h.top().count()) {
    level &l = h.levels[h.depth++];
    l.boxes = boxes;
    l.blocks = from.take<box_block>(l.count());
    if (h.depth > 1 && boxes <= lanes)
      break;
  }
  return h;
}

void enclose(hierarchy &h, int threads) {
  for (int k = 1; k < h.depth; ++k) {
    const level &below = h.levels[k - 1], &here = h.levels[k];
    for_chunks(threads, here.count(), 256, [&](int, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        here.blocks[i].clear();
        for (std::size_t child = i * lanes; child < std::min(here.boxes, (i + 1) * lanes); ++child)
          here.blocks[i].set(static_cast<int>(child % lanes), below.blocks[child].around());
      }
    });
  }
}

} // namespace meetc
