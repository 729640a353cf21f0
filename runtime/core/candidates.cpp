#include "core/candidates.hpp"

#include <bit>

namespace meetc {
namespace {

// Writes the pairs of slot a, whose box is q, with one block of b. Returns the end of the pairs written.
inline index_pair *pairs_with(const box &q, std::uint32_t a, const box_block *blocks, std::size_t block,
                              index_pair *out) {
  const auto first = static_cast<std::uint32_t>(block * lanes);
  for (std::uint32_t mask = touching(blocks[block], q); mask != 0; mask &= mask - 1)
    *out++ = {a, first + static_cast<std::uint32_t>(std::countr_zero(mask))};
  return out;
}

std::size_t lanes_of(const level &l, std::size_t block) {
  return std::min<std::size_t>(lanes, l.boxes - block * lanes);
}

// One walk down the hierarchy of b with one block of a. Leaf blocks are collected first, so that runs of one a are
// long.
class walk {
public:
  walk(const element_set &a, std::size_t block, const element_set &b, pair_sink &sink)
      : a_(a.boxes.levels[0]), a_block_(block), around_(a.boxes.levels[1].get(block)), b_(b.boxes), sink_(sink) {}

  bool down(int at, std::size_t block) {
    const level &l = b_.levels[at];
    for (std::uint32_t mask = touching(l.blocks[block], around_); mask != 0; mask &= mask - 1) {
      const std::size_t child = block * lanes + static_cast<std::size_t>(std::countr_zero(mask));
      if (!(at == 1 ? collect(child, l.get(child)) : down(at - 1, child)))
        return false;
    }
    return true;
  }

  bool finish() {
    const std::size_t n = size_;
    size_ = 0;
    for (std::size_t lane = 0; lane < lanes_of(a_, a_block_); ++lane) {
      std::size_t chosen[most], count = 0;
      for (std::size_t i = 0; i < n; ++i) {
        chosen[count] = leaves_[i];
        count += lanes_of_a_[i] >> lane & 1;
      }
      if (count == 0)
        continue;
      const box q = a_.blocks[a_block_].get(static_cast<int>(lane));
      const auto slot = static_cast<std::uint32_t>(a_block_ * lanes + lane);
      index_pair *const begin = sink_.room(), *end = begin;
      for (std::size_t i = 0; i < count; ++i)
        end = pairs_with(q, slot, b_.levels[0].blocks, chosen[i], end);
      if (!sink_.advance(static_cast<std::size_t>(end - begin)))
        return false;
    }
    return true;
  }

private:
  bool collect(std::size_t leaf, const box &b) {
    const std::uint32_t mask = touching(a_.blocks[a_block_], b);
    leaves_[size_] = leaf;
    lanes_of_a_[size_] = mask;
    size_ += mask != 0 && touching(b_.levels[0].blocks[leaf], around_) != 0;
    return size_ < most || finish();
  }

  static constexpr std::size_t most = pair_sink::longest_run / lanes;
  const level &a_;
  std::size_t a_block_;
  box around_;
  const hierarchy &b_;
  pair_sink &sink_;
  std::size_t size_ = 0;
  std::size_t leaves_[most];
  std::uint32_t lanes_of_a_[most]; // the elements of a's block that the box around the leaf touches
};

constexpr std::size_t tile = 64; // blocks of b: 24 KiB of boxes, which stay in the first cache

std::size_t tiles(const element_set &b) {
  return (b.boxes.levels[0].count() + tile - 1) / tile;
}

} // namespace

std::size_t all_pairs::units() const {
  return a_.boxes.levels[0].count() * tiles(b_);
}

bool all_pairs::yield(std::size_t unit, pair_sink &sink) const {
  const level &a = a_.boxes.levels[0], &b = b_.boxes.levels[0];
  const std::size_t block = unit / tiles(b_), first = unit % tiles(b_) * tile;
  for (std::size_t lane = 0; lane < lanes_of(a, block); ++lane) {
    const box q = a.blocks[block].get(static_cast<int>(lane));
    const auto slot = static_cast<std::uint32_t>(block * lanes + lane);
    index_pair *const begin = sink.room(), *end = begin;
    for (std::size_t i = first; i < std::min(b.count(), first + tile); ++i)
      end = pairs_with(q, slot, b.blocks, i, end);
    if (!sink.advance(static_cast<std::size_t>(end - begin)))
      return false;
  }
  return true;
}

// There is one walk for each block of a. Where a has few blocks, b is cut as well, so that every thread finds work.
tree_pairs::tree_pairs(const element_set &a, const element_set &b) : a_(a), b_(b) {
  constexpr std::size_t enough = 1024;
  if (a.elements == 0 || b.elements == 0)
    return;
  start_ = b.boxes.depth - 1;
  while (start_ > 1 && a.boxes.levels[0].count() * b.boxes.levels[start_].count() < enough)
    --start_;
  starts_ = b.boxes.levels[start_].count();
}

std::size_t tree_pairs::units() const {
  return a_.boxes.levels[0].count() * starts_;
}

bool tree_pairs::yield(std::size_t unit, pair_sink &sink) const {
  walk w(a_, unit / starts_, b_, sink);
  return w.down(start_, unit % starts_) && w.finish();
}

} // namespace meetc
