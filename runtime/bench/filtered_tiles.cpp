#include "bench/filtered_tiles.hpp"

#include <algorithm>
#include <bit>

namespace meetc::bench {

namespace {

float *floats_in(const owned_memory &m) {
  return static_cast<float *>(m.get());
}

} // namespace

filtered_tiles::filtered_tiles(const predicate_info &predicate, rung precision, const float *rows_a,
                               std::size_t count_a, const float *rows_b, std::size_t count_b)
    : filter_(*predicate.a->filter), rung_(predicate.decide[static_cast<int>(precision)]), rows_a_(rows_a),
      rows_b_(rows_b), fields_a_(static_cast<std::size_t>(predicate.a->fields)),
      fields_b_(static_cast<std::size_t>(predicate.b->fields)), floats_(static_cast<std::size_t>(filter_.floats)),
      singles_(allocate(count_a * floats_ * sizeof(float))),
      tiles_(allocate((count_b + filter_tile) * floats_ * sizeof(float))),
      groups_(allocate((count_b / filter_tile + 1 + filter_tile) * floats_ * sizeof(float))) {
  filter_extent frame;
  predicate.b->filter->widen(rows_b, count_b, frame);
  filter_.singles(frame, rows_a, count_a, floats_in(singles_));
  predicate.b->filter->tiles(frame, rows_b, count_b, floats_in(tiles_));
  predicate.b->filter->groups(frame, rows_b, count_b, floats_in(groups_));
}

void filtered_tiles::decide(const pair_tile &tile, answer *out) const {
  near_tile near[most_tile_columns / filter_tile];
  index_pair pairs[most_tile_rows * most_tile_columns];
  answer answers[most_tile_rows * most_tile_columns];
  std::fill_n(out, tile.rows * tile.n, answer::no);
  std::size_t size = 0;
  for (std::size_t r = 0; r < tile.rows; ++r) {
    const near_tile *const end = filter_.near(
        floats_in(singles_) + (tile.row + r) * floats_, floats_in(groups_) + tile.from / filter_tile * floats_,
        floats_in(tiles_) + tile.from * floats_, (tile.n + filter_tile - 1) / filter_tile, near);
    for (const near_tile *t = near; t < end; ++t)
      for (std::uint32_t left = t->elements; left != 0; left &= left - 1) {
        const std::size_t k = std::size_t{t->index} * filter_tile + static_cast<std::size_t>(std::countr_zero(left));
        pairs[size] = {static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(k)};
        size += k < tile.n;
      }
  }
  if (size == 0)
    return;
  rung_(rows_a_ + tile.row * fields_a_, rows_b_ + tile.from * fields_b_, pairs, size, answers);
  for (std::size_t k = 0; k < size; ++k)
    out[pairs[k].a * tile.n + pairs[k].b] = answers[k];
}

} // namespace meetc::bench
