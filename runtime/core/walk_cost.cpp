#include "core/walk_cost.hpp"

namespace meetc {
namespace {

// The mean widths of a level's boxes as shares of a region; where the region is flat, everything fills it.
struct shares {
  double of[3];

  shares(const level &l, const double region[3]) {
    for (int k = 0; k < 3; ++k)
      of[k] = region[k] > 0 ? l.widths[k] / static_cast<double>(l.boxes) / region[k] : 1;
  }
};

double boxes_touch(const shares &x, const shares &y) {
  double p = 1;
  for (int k = 0; k < 3; ++k)
    p *= std::min(1.0, x.of[k] + y.of[k]);
  return p;
}

double segment_touches(const shares &s, const shares &b) {
  const double sum = b.of[0] * b.of[1] * b.of[2] + s.of[0] * b.of[1] * b.of[2] + b.of[0] * s.of[1] * b.of[2] +
                     b.of[0] * b.of[1] * s.of[2];
  return std::min(sum, boxes_touch(s, b));
}

} // namespace

double expected_tests(const candidate_operand &walker, const candidate_operand &tree) {
  const hierarchy &w = walker.set.boxes, &t = tree.set.boxes;
  const box x = w.top().blocks[0].around(), y = t.top().blocks[0].around();
  double region[3];
  for (int k = 0; k < 3; ++k)
    region[k] = static_cast<double>(std::max(x.hi[k], y.hi[k])) - static_cast<double>(std::min(x.lo[k], y.lo[k]));

  const level &elements = w.levels[0], &blocks = w.levels[1];
  const shares element(elements, region), block(blocks, region);
  double tests = 0;
  for (int k = 1; k < t.depth; ++k) {
    const level &l = t.levels[k];
    const shares node(l, region);
    const double by_block = static_cast<double>(blocks.boxes) * boxes_touch(block, node);
    const double by_element = static_cast<double>(elements.boxes) * segment_touches(element, node);
    tests += static_cast<double>(l.boxes) * (walker.by_points ? std::min(by_block, by_element) : by_block);
    if (k == 1 && !walker.by_points) // the elements of a block that touches a leaf, each against the leaf's elements
      tests += static_cast<double>(l.boxes) * static_cast<double>(elements.boxes) * boxes_touch(element, node);
  }
  return tests;
}

} // namespace meetc
