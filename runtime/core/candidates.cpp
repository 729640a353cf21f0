#include "core/candidates.hpp"

#include "core/probe.hpp"
#include "core/walk_cost.hpp"

namespace meetc {
namespace {

// One walk down the hierarchy of `tree` with one block of `walker`. It collects the leaf blocks of each element first,
// so that runs of one element are long.
class walk {
public:
  walk(const candidate_operand &walker, std::size_t block, const candidate_operand &tree, bool swapped, pair_sink &sink)
      : walker_(walker), tree_(tree), swapped_(swapped), boxes_(walker.set.boxes.levels[0].blocks[block]),
        first_(block * lanes), filled_(walker.set.boxes.levels[0].filled(block)),
        around_(walker.set.boxes.levels[1].get(block)), sink_(sink) {
    if (walker.by_points)
      for (std::size_t i = 0; i < filled_; ++i)
        points_[i] = points_at(walker.set, first_ + i);
  }

  bool start(int at, std::size_t block) { return down(at, block, (1u << filled_) - 1); }

  bool finish() {
    bool more = true;
    for (std::size_t i = 0; i < filled_ && more; ++i)
      more = take(i);
    return more;
  }

private:
  using mask = std::uint32_t; // of sixteen lanes

  // Goes down from one block with the elements in `active`.
  bool down(int at, std::size_t block, mask active) {
    const level &l = tree_.set.boxes.levels[at];
    mask children = touching(l.blocks[block], around_);
    mask active_in[lanes];
    // One test takes one element against all children, or one child against all elements: the fewer are taken.
    if (walker_.by_points && std::popcount(active) <= std::popcount(children))
      children = by_points(l.blocks[block], children, active, active_in);
    else
      std::fill_n(active_in, lanes, active);
    for (; children != 0; children &= children - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(children));
      const std::size_t child = block * lanes + lane;
      if (!(at == 1 ? collect(child, active_in[lane]) : down(at - 1, child, active_in[lane])))
        return false;
    }
    return true;
  }

  // The children that some active element may touch; active_in says which elements each of them may touch.
  mask by_points(const box_block &boxes, mask children, mask active, mask active_in[lanes]) const {
    std::fill_n(active_in, lanes, 0);
    mask any = 0;
    for (; active != 0; active &= active - 1) {
      const mask touched = touching(boxes, points_[std::countr_zero(active)]) & children;
      any |= touched;
      for (mask m = touched; m != 0; m &= m - 1)
        active_in[std::countr_zero(m)] |= active & -active;
    }
    return any;
  }

  bool collect(std::size_t leaf, mask active) {
    const hierarchy &h = tree_.set.boxes;
    if (std::popcount(active) > 1)
      active &= touching(boxes_, h.levels[1].get(leaf));
    if (active == 0 || touching(h.levels[0].blocks[leaf], around_) == 0)
      return true;
    for (; active != 0; active &= active - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(active));
      leaves_[i][sizes_[i]++] = static_cast<std::uint32_t>(leaf);
      if (sizes_[i] == most && !take(i))
        return false;
    }
    return true;
  }

  // Yields the pairs of element i with its leaf blocks.
  bool take(std::size_t i) {
    if (sizes_[i] == 0)
      return true;
    const probe one(walker_, first_ + i, tree_, swapped_);
    index_pair *const begin = sink_.room(), *end = begin;
    for (std::size_t n = 0; n < sizes_[i]; ++n)
      end = one.pairs_with(leaves_[i][n], end);
    sizes_[i] = 0;
    return sink_.advance(static_cast<std::size_t>(end - begin));
  }

  static constexpr std::size_t most = pair_sink::longest_run / lanes;
  const candidate_operand &walker_, &tree_;
  bool swapped_;
  const box_block &boxes_;
  std::size_t first_, filled_;
  box around_;
  pair_sink &sink_;
  two_points points_[lanes];
  std::size_t sizes_[lanes] = {};
  std::uint32_t leaves_[lanes][most]; // the leaf blocks that each element may touch
};

constexpr std::size_t tile = 64; // blocks of b: 24 KiB of boxes, which stay in the first cache

std::size_t tiles(const element_set &b) {
  return (b.boxes.levels[0].count() + tile - 1) / tile;
}

} // namespace

candidate_operand::candidate_operand(const element_set &s, ruled_out_by what)
    : set(s), by_points(what == ruled_out_by::boxes_and_points && has_two_points(*s.kind)) {}

std::size_t all_pairs::units() const {
  return a_.set.boxes.levels[0].count() * tiles(b_.set);
}

bool all_pairs::yield(std::size_t unit, pair_sink &sink) const {
  const level &a = a_.set.boxes.levels[0], &b = b_.set.boxes.levels[0];
  const std::size_t block = unit / tiles(b_.set), first = unit % tiles(b_.set) * tile;
  for (std::size_t lane = 0; lane < a.filled(block); ++lane) {
    const probe one(a_, block * lanes + lane, b_, false);
    index_pair *const begin = sink.room(), *end = begin;
    for (std::size_t i = first; i < std::min(b.count(), first + tile); ++i)
      end = one.pairs_with(i, end);
    if (!sink.advance(static_cast<std::size_t>(end - begin)))
      return false;
  }
  return true;
}

// There is one walk for each block of the set that walks. Where it has few blocks, the other is cut as well, so that
// every thread finds work.
tree_pairs::tree_pairs(const element_set &a, const element_set &b, ruled_out_by what) : a_(a, what), b_(b, what) {
  constexpr std::size_t enough = 1024;
  if (a.elements == 0 || b.elements == 0)
    return;
  b_walks_ = expected_tests(b_, a_) < expected_tests(a_, b_);
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
  walk w(b_walks_ ? b_ : a_, unit / starts_, b_walks_ ? a_ : b_, b_walks_, sink);
  return w.start(start_, unit % starts_) && w.finish();
}

} // namespace meetc
