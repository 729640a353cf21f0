// bench/filtered_tiles.hpp: elements against a tile of others, by a predicate's rung behind the separable filter.
#ifndef MEETC_BENCH_FILTERED_TILES_HPP
#define MEETC_BENCH_FILTERED_TILES_HPP

#include "bench/every_pair.hpp"
#include "core/memory.hpp"
#include "meetc/table.hpp"

namespace meetc::bench {

// The filter's numbers of two sets of rows. The predicate's kinds have filters, and the rows outlive it.
class filtered_tiles {
public:
  filtered_tiles(const predicate_info &predicate, rung precision, const float *rows_a, std::size_t count_a,
                 const float *rows_b, std::size_t count_b);

  // As tile_test, where tile.from is a multiple of filter_tile^2. What the filter rules out is `no`. Any thread may call.
  void decide(const pair_tile &tile, answer *out) const;

private:
  const kind_filter &filter_;
  decide_function rung_;
  const float *rows_a_, *rows_b_;
  std::size_t fields_a_, fields_b_, floats_;
  owned_memory singles_, tiles_, groups_; // as those of core/pair_filter.hpp
};

} // namespace meetc::bench

#endif
