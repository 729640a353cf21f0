// core/walk.hpp: two ways down a hierarchy: a block of sixteen elements together, and one element with two points.
#ifndef MEETC_CORE_WALK_HPP
#define MEETC_CORE_WALK_HPP

#include "core/probe.hpp"

#include <algorithm>

namespace meetc {

// A walk of half of the pairs of a set with itself leaves out those whose other slot is below the walker's.
//
// Whether a block of the level below `at` has only blocks of elements before `first`.
inline bool lies_before(std::size_t block, int at, std::size_t first) {
  static_assert(lanes == 16);
  return (block + 1) << (4 * (at - 1)) <= first;
}
// Drops the pairs of `slot` with lower slots from a run, and returns its end.
inline index_pair *without_lower(std::size_t slot, index_pair *begin, index_pair *end) {
  return std::remove_if(begin, end, [slot](const index_pair &p) { return p.b < slot; });
}

// Tests the box around a block of `walker` against the boxes of `tree`, and yields the candidates of its elements. It
// collects the leaf blocks first, so that runs of one element are long.
class block_walk {
public:
  block_walk(const candidate_operand &walker, std::size_t block, const candidate_operand &tree, bool swapped, bool half,
             pair_sink &sink)
      : walker_(walker), tree_(tree), block_(block), around_(walker.set.boxes.levels[1].get(block)), swapped_(swapped),
        half_(half), sink_(sink) {}

  // Walks down from one block of level `at` >= 1. Returns false when the sink asks to stop.
  bool from(int at, std::size_t block) { return down(at, block) && finish(); }

private:
  bool down(int at, std::size_t block) {
    const level &l = tree_.set.boxes.levels[at];
    if (at == 1)
      return collect(l.blocks[block], block);
    for (std::uint32_t mask = tests_.touching(l.blocks[block], around_); mask != 0; mask &= mask - 1) {
      const std::size_t child = block * lanes + static_cast<std::size_t>(std::countr_zero(mask));
      if (half_ && lies_before(child, at, block_))
        continue;
      if (!down(at - 1, child))
        return false;
    }
    return true;
  }

  bool collect(const box_block &around_leaves, std::size_t block) {
    if (size_ + lanes > most && !finish())
      return false;
    size_ += tests_.leaves({&mine(), tree_.set.boxes.levels[0].blocks, &around_leaves,
                            static_cast<std::uint32_t>(block * lanes), half_ ? static_cast<std::uint32_t>(block_) : 0,
                            around_},
                           leaves_ + size_, elements_ + size_);
    return true;
  }

  bool finish() {
    std::size_t counts[lanes] = {};
    for (std::size_t i = 0; i < size_; ++i)
      for (std::uint32_t left = elements_[i]; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        chosen_[lane][counts[lane]++] = leaves_[i];
      }
    size_ = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (counts[lane] == 0)
        continue;
      const probe one(walker_, block_ * lanes + lane, tree_, swapped_);
      index_pair *const begin = sink_.room(), *end = one.pairs_with(chosen_[lane], counts[lane], begin);
      if (half_ && chosen_[lane][0] == block_) // blocks come in their order
        end = without_lower(block_ * lanes + lane, begin, end);
      if (!sink_.advance(static_cast<std::size_t>(end - begin)))
        return false;
    }
    return true;
  }

  const box_block &mine() const { return walker_.set.boxes.levels[0].blocks[block_]; }

  static constexpr std::size_t most = pair_sink::longest_run / lanes;
  const box_tests &tests_ = best_box_tests();
  const candidate_operand &walker_, &tree_;
  std::size_t block_;
  box around_;
  bool swapped_, half_;
  pair_sink &sink_;
  std::size_t size_ = 0;
  std::uint32_t leaves_[most], elements_[most]; // blocks, and the elements that the box around each touches
  std::uint32_t chosen_[lanes][most];           // the blocks of each element
};

// Tests the two points of one element of `walker` against the boxes of `tree`. A long element visits the boxes along
// it, and not those within its box.
class element_walk {
public:
  element_walk(const candidate_operand &walker, std::size_t slot, const candidate_operand &tree, bool swapped,
               bool half, pair_sink &sink)
      : one_(walker, slot, tree, swapped), tree_(tree.set.boxes), slot_(slot), half_(half), sink_(sink),
        end_(sink.room()) {}

  bool from(int at, std::size_t block) { return down(at, block) && advance(); }

private:
  bool down(int at, std::size_t block) {
    const level &l = tree_.levels[at];
    std::uint32_t mask = touching(l.blocks[block], one_.points()) & ((1u << l.filled(block)) - 1);
    for (; mask != 0; mask &= mask - 1) {
      const std::size_t child = block * lanes + static_cast<std::size_t>(std::countr_zero(mask));
      if (half_ && lies_before(child, at, slot_ / lanes))
        continue;
      if (!(at == 1 ? take(child) : down(at - 1, child)))
        return false;
    }
    return true;
  }

  bool take(std::size_t leaf) {
    index_pair *const begin = end_;
    end_ = one_.pairs_by_points(leaf, end_);
    if (half_ && leaf == slot_ / lanes)
      end_ = without_lower(slot_, begin, end_);
    return end_ + lanes <= sink_.room() + pair_sink::longest_run || advance();
  }

  bool advance() {
    const bool more = sink_.advance(static_cast<std::size_t>(end_ - sink_.room()));
    end_ = sink_.room();
    return more;
  }

  probe one_;
  const hierarchy &tree_;
  std::size_t slot_;
  bool half_;
  pair_sink &sink_;
  index_pair *end_; // of the pairs in the sink's room
};

} // namespace meetc

#endif
