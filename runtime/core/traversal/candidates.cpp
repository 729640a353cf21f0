#include "meet/core/traversal/candidates.hpp"

#include "meet/core/traversal/walk.hpp"
#include "meet/core/traversal/walk_cost.hpp"

namespace meetc {

// There is a unit for each block of the set that walks. Where it has few blocks, the other is cut as well, so that
// every thread finds work.
tree_pairs::tree_pairs(const element_set &a, const element_set &b, ruled_out_by what, bool half)
    : a_(a, what), b_(b, what), half_(half) {
  constexpr std::size_t enough = 256;
  if (a.elements == 0 || b.elements == 0)
    return;
  cost_.emplace(a_, b_);
  const walk_cost other(b_, a_);
  b_walks_ = !half && other.of_all() < cost_->of_all();
  if (b_walks_)
    cost_.emplace(b_, a_);
  const hierarchy &walker = (b_walks_ ? b : a).boxes, &tree = (b_walks_ ? a : b).boxes;
  start_ = tree.depth - 1;
  while (start_ > 1 && walker.levels[0].count() * tree.levels[start_].count() < enough)
    --start_;
  starts_ = tree.levels[start_].count();
}

std::size_t tree_pairs::units() const {
  return (b_walks_ ? b_ : a_).set.boxes.levels[0].count() * starts_;
}

bool tree_pairs::yield(std::size_t unit, pair_sink &sink) const {
  const candidate_operand &walker = b_walks_ ? b_ : a_, &tree = b_walks_ ? a_ : b_;
  const std::size_t block = unit / starts_, start = unit % starts_;
  if (!cost_->one_by_one(block))
    return block_walk(walker, block, tree, b_walks_, half_, sink).from(start_, start);
  bool more = true;
  for (std::size_t lane = 0; lane < walker.set.boxes.levels[0].filled(block) && more; ++lane)
    more = element_walk(walker, block * lanes + lane, tree, b_walks_, half_, sink).from(start_, start);
  return more;
}

} // namespace meetc
