#include "core/candidates.hpp"

#include "core/walk.hpp"
#include "core/walk_cost.hpp"

#include <algorithm>

namespace meetc {
namespace {

constexpr std::size_t tile = 64; // blocks of b: 24 KiB of boxes, which stay in the first cache
static_assert(tile % filter_tile == 0, "a filter's groups of blocks are not split");
static_assert(tile <= affine_pairs::most_tiles);
// The filter by signs looks at all blocks of a tile. It costs about as much a block as a test of boxes, and is asked where
// the filter by balls leaves more than one block in this many.
constexpr std::size_t much = 4;

std::size_t tiles(const element_set &b) {
  return (b.boxes.levels[0].count() + tile - 1) / tile;
}

} // namespace

std::size_t all_pairs::units() const {
  return a_.set.boxes.levels[0].count() * tiles(b_.set);
}

bool all_pairs::yield(std::size_t unit, pair_sink &sink) const {
  const level &a = a_.set.boxes.levels[0], &b = b_.set.boxes.levels[0];
  const std::size_t block = unit / tiles(b_.set), first = unit % tiles(b_.set) * tile;
  const std::size_t count = std::min(b.count() - first, tile);
  for (std::size_t lane = 0; lane < a.filled(block); ++lane) {
    const std::size_t slot = block * lanes + lane;
    near_tile near[tile];
    const near_tile *const near_end = filter_ ? filter_->near(slot, first, count, near) : every_tile(count, near);
    const bool by_signs = signs_ && static_cast<std::size_t>(near_end - near) * much > count;
    std::uint32_t left[tile]; // by signs, the elements of each block
    if (by_signs)
      signs_->elements(slot, first, count, left);
    std::uint32_t chosen[tile];
    std::size_t size = 0;
    for (const near_tile *at = near; at < near_end; ++at) // the boxes rule out what the filter by balls does
      if (!by_signs || left[at->index] != 0)
        chosen[size++] = static_cast<std::uint32_t>(first + at->index);
    if (size == 0)
      continue;
    const probe one(a_, slot, b_, false);
    index_pair *const begin = sink.room(), *end = one.pairs_with(chosen, size, begin);
    if (by_signs)
      end = std::remove_if(begin, end, [&](index_pair p) { return !(left[p.b / lanes - first] >> p.b % lanes & 1); });
    if (!sink.advance(static_cast<std::size_t>(end - begin)))
      return false;
  }
  return true;
}

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
