#include "meet/core/hierarchy/hierarchy.hpp"

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
  constexpr int sums = 4; // which do not wait for each other
  for (int k = 0; k < 3; ++k) {
    double sum[sums] = {};
    std::size_t i = 0;
    for (; i + sums <= filled; i += sums)
      for (std::size_t s = 0; s < sums; ++s)
        sum[s] += static_cast<double>(block.hi[k][i + s]) - static_cast<double>(block.lo[k][i + s]);
    for (; i < filled; ++i)
      sum[0] += static_cast<double>(block.hi[k][i]) - static_cast<double>(block.lo[k][i]);
    widths[k] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
}

void enclose(hierarchy &h, const execution &on) {
  std::mutex lock;
  // The boxes of a level are read once, for the sums of their widths and for the boxes around them.
  const auto add = [&](level &to, const double widths[3]) {
    const std::scoped_lock hold(lock);
    for (int axis = 0; axis < 3; ++axis)
      to.widths[axis] += widths[axis];
  };
  for (int k = 0; k < h.depth; ++k)
    std::fill_n(h.levels[k].widths, 3, 0.0);
  for (int k = 1; k < h.depth; ++k) {
    level &here = h.levels[k], &below = h.levels[k - 1];
    for_chunks(on, here.count(), lanes, [&](int, std::size_t begin, std::size_t end) {
      double widths[3] = {0, 0, 0};
      for (std::size_t i = begin; i < end; ++i) {
        here.blocks[i].clear();
        for (std::size_t child = i * lanes; child < std::min(here.boxes, (i + 1) * lanes); ++child) {
          here.blocks[i].set(static_cast<int>(child % lanes), below.blocks[child].around());
          add_widths(below.blocks[child], below.filled(child), widths);
        }
      }
      add(below, widths);
    });
  }
  if (h.depth > 0) {
    double widths[3] = {0, 0, 0};
    level &top = h.levels[h.depth - 1];
    add_widths(top.blocks[0], top.filled(0), widths);
    add(top, widths);
  }
}

} // namespace meetc
