// core/affine_pairs.hpp: the affine filter of two sets of rows, by which a query that looks at all pairs rules out what the
// predicate's reject stage proves apart.
//
// It costs about as much a pair as comparing two balls, does not depend on the elements' size, and so serves where balls
// or boxes are large: for long elements, or where kinds have no filter by balls.
#ifndef MEETC_CORE_AFFINE_PAIRS_HPP
#define MEETC_CORE_AFFINE_PAIRS_HPP

#include "core/memory.hpp"

#include "meetc/table.hpp"

namespace meetc {

// Tiles 0 to count - 1 with all their elements, as from a filter that rules nothing out. Returns the end.
near_tile *every_tile(std::size_t count, near_tile *out);

class affine_pairs {
public:
  // Whether the predicate has such a filter, and the sets are so large that making the numbers costs less than it saves.
  static bool pays(const predicate_info &predicate, std::size_t a, std::size_t b);

  // The predicate has such a filter; rows are packed, and need not outlive it. Throws std::bad_alloc.
  affine_pairs(const predicate_info &predicate, const float *rows_a, std::size_t count_a, const float *rows_b,
               std::size_t count_b, int threads);

  // Writes which of `count` tiles of b from `first` on hold an element that may touch a's row `i`. Their indices count from
  // `first`. Returns the end. Elements behind the last of b repeat it.
  near_tile *near(std::size_t i, std::size_t first, std::size_t count, near_tile *out) const;
  // The same as a mask of elements for each tile, of at most most_tiles.
  static constexpr std::size_t most_tiles = 64;
  void elements(std::size_t i, std::size_t first, std::size_t count, std::uint32_t *out) const;

private:
  const affine_filter &filter_;
  bool usable_; // otherwise nothing is ruled out
  owned_memory singles_, tiles_;
};

} // namespace meetc

#endif
