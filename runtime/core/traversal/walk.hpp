// core/traversal/walk.hpp: two ways down a hierarchy: a block of sixteen elements together, and one element with two points.
#ifndef MEETC_CORE_TRAVERSAL_WALK_HPP
#define MEETC_CORE_TRAVERSAL_WALK_HPP

#include "meet/core/hierarchy/box_tests.hpp"
#include "meet/core/traversal/candidates.hpp"
#include "meet/core/traversal/probe.hpp"

#include <algorithm>
#include <span>

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

// Tests the box around a block of `walker` against the boxes of `tree`, sixteen blocks of a level at a time, and yields the
// candidates of its elements, which come in long runs of one element.
class block_walk {
public:
  block_walk(const candidate_operand &walker, std::size_t block, const candidate_operand &tree, bool swapped, bool half,
             pair_sink &sink)
      : walker_(walker), tree_(tree), block_(block), around_(walker.set.boxes.levels[1].get(block)), swapped_(swapped),
        half_(half), sink_(sink) {}

  // Walks down from one block of level `at` >= 1. Returns false when the sink asks to stop.
  bool from(int at, std::size_t block) {
    const auto number = static_cast<std::uint32_t>(block);
    return down(at, &number, 1);
  }

private:
  // From at most sixteen blocks, in their order.
  bool down(int at, const std::uint32_t *blocks, std::size_t n) {
    std::uint32_t *child = children_[at - 1];
    const std::uint32_t *const end =
        child + tests_.touched(tree_.set.boxes.levels[at].blocks, blocks, n, around_, child);
    while (half_ && child < end && lies_before(*child, at, block_)) // they rise
      ++child;
    for (; child < end; child += lanes) {
      const std::size_t some = std::min<std::size_t>(static_cast<std::size_t>(end - child), lanes);
      if (!(at == 1 ? meet(child, some) : down(at - 1, child, some)))
        return false;
    }
    return true;
  }

  // Yields the candidates of at most sixteen leaf blocks.
  bool meet(const std::uint32_t *leaves, std::size_t n) {
    static_assert(most_meetings * lanes <= pair_sink::longest_run);
    const level *const levels = tree_.set.boxes.levels;
    meeting found[most_meetings];
    const std::span meetings(found, tests_.meetings({&walker_.set.boxes.levels[0].blocks[block_], levels[0].blocks,
                                                     levels[1].blocks, leaves, n, around_},
                                                    found));
    if (half_ && leaves[0] == block_) // no block before it is visited
      for (meeting &m : meetings)
        if (m.block() == block_)
          m.mask &= ~((std::uint32_t{1} << m.lane()) - 1);
    index_pair *const begin = sink_.room();
    const index_pair *const end = walker_.by_points || tree_.by_points
                                      ? pairs_by_points(meetings, begin)
                                      : tests_.pairs_of(found, meetings.size(), first(), swapped_, begin);
    return sink_.advance(static_cast<std::size_t>(end - begin));
  }

  index_pair *pairs_by_points(std::span<const meeting> meetings, index_pair *end) const {
    for (std::size_t i = 0; i < meetings.size();) {
      const std::uint32_t lane = meetings[i].lane();
      const probe one(walker_, first() + lane, tree_, swapped_);
      for (; i < meetings.size() && meetings[i].lane() == lane; ++i)
        end = one.pairs_among(meetings[i].block(), meetings[i].mask, end);
    }
    return end;
  }

  std::uint32_t first() const { return static_cast<std::uint32_t>(block_ * lanes); } // the slot of lane 0

  const box_tests &tests_ = best_box_tests();
  const candidate_operand &walker_, &tree_;
  std::size_t block_;
  box around_;
  bool swapped_, half_;
  pair_sink &sink_;
  std::uint32_t children_[8][std::size_t{lanes} * lanes]; // the blocks of each level that are to be visited
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
