#include "meet/core/traversal/walk_cost.hpp"

namespace meetc {
namespace {

// The time of a test by points, in those of a test of boxes. It has twice the arithmetic, and is compiled for the baseline
// alone; docs/cpu.md has the times of other numbers.
constexpr double by_points = 4;

template <class Shares> double boxes_touch(const Shares &x, const Shares &y) {
  double p = 1;
  for (int k = 0; k < 3; ++k)
    p *= std::min(1.0, x.of[k] + y.of[k]);
  return p;
}

template <class Shares> double segment_touches(const Shares &s, const Shares &b) {
  const double sum = b.of[0] * b.of[1] * b.of[2] + s.of[0] * b.of[1] * b.of[2] + b.of[0] * s.of[1] * b.of[2] +
                     b.of[0] * b.of[1] * s.of[2];
  return std::min(sum, boxes_touch(s, b));
}

} // namespace

// Where the region is flat, everything fills it.
walk_cost::shares walk_cost::share(const double widths[3]) const {
  shares s;
  for (int k = 0; k < 3; ++k)
    s.of[k] = region_[k] > 0 ? widths[k] / region_[k] : 1;
  return s;
}

walk_cost::walk_cost(const candidate_operand &walker, const candidate_operand &tree)
    : walker_(walker), depth_(tree.set.boxes.depth) {
  const hierarchy &t = tree.set.boxes;
  const box x = walker.set.boxes.top().blocks[0].around(), y = t.top().blocks[0].around();
  for (int k = 0; k < 3; ++k)
    region_[k] = static_cast<double>(std::max(x.hi[k], y.hi[k])) - static_cast<double>(std::min(x.lo[k], y.lo[k]));
  for (int at = 0; at < depth_; ++at) {
    boxes_[at] = static_cast<double>(t.levels[at].boxes);
    double widths[3];
    for (int k = 0; k < 3; ++k)
      widths[k] = t.levels[at].widths[k] / boxes_[at];
    nodes_[at] = share(widths);
  }
}

// The box around a block is tested down to the leaf blocks, and then each element against the leaf blocks that it
// touches.
double walk_cost::together(const shares &block, const shares &element) const {
  double tests = 1 + lanes * boxes_[1] * boxes_touch(element, nodes_[1]);
  for (int at = 1; at < depth_; ++at)
    tests += boxes_[at] * boxes_touch(block, nodes_[at]);
  return tests;
}

// The top block is tested, and then the blocks within each box that is touched.
double walk_cost::one(const shares &element) const {
  double tests = 1;
  for (int at = 1; at < depth_; ++at)
    tests += boxes_[at] * segment_touches(element, nodes_[at]);
  return by_points * tests;
}

bool walk_cost::one_by_one(std::size_t block) const {
  if (!walker_.by_points)
    return false;
  const level &elements = walker_.set.boxes.levels[0];
  const box around = walker_.set.boxes.levels[1].get(block);
  double whole[3], mean[3] = {0, 0, 0};
  add_widths(elements.blocks[block], elements.filled(block), mean);
  for (int k = 0; k < 3; ++k) {
    whole[k] = static_cast<double>(around.hi[k]) - static_cast<double>(around.lo[k]);
    mean[k] /= static_cast<double>(elements.filled(block));
  }
  const shares element = share(mean);
  return lanes * one(element) < together(share(whole), element);
}

double walk_cost::of_all() const {
  const level &elements = walker_.set.boxes.levels[0], &blocks = walker_.set.boxes.levels[1];
  double mean[3], whole[3];
  for (int k = 0; k < 3; ++k) {
    mean[k] = elements.widths[k] / static_cast<double>(elements.boxes);
    whole[k] = blocks.widths[k] / static_cast<double>(blocks.boxes);
  }
  const shares element = share(mean);
  const double of_block = together(share(whole), element);
  return static_cast<double>(blocks.boxes) * (walker_.by_points ? std::min(of_block, lanes * one(element)) : of_block);
}

} // namespace meetc
