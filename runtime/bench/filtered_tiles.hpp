// bench/filtered_tiles.hpp: elements against a tile of others, by a predicate's rung behind a filter.
#ifndef MEETC_BENCH_FILTERED_TILES_HPP
#define MEETC_BENCH_FILTERED_TILES_HPP

#include "bench/every_pair.hpp"
#include "meetc/table.hpp"

namespace meetc::bench {

// Rules out pairs of one element of a and tiles of b: (row of a, first tile, tiles, out), as kind_filter::near.
using tile_filter = std::function<near_tile *(std::size_t, std::size_t, std::size_t, near_tile *)>;

// By the balls around the boxes of elements; both kinds have filters.
tile_filter filter_by_balls(const predicate_info &predicate, const float *rows_a, std::size_t count_a,
                            const float *rows_b, std::size_t count_b);
// By the reject stage; the predicate has an affine filter.
tile_filter filter_by_signs(const predicate_info &predicate, const float *rows_a, std::size_t count_a,
                            const float *rows_b, std::size_t count_b);

// A tile_test whose tiles begin at multiples of filter_tile^2. What the filter rules out is `no`, and the rung decides the
// rest. The rows outlive it. Any thread may call.
tile_test behind(tile_filter filter, const predicate_info &predicate, rung precision, const float *rows_a,
                 const float *rows_b);

} // namespace meetc::bench

#endif
