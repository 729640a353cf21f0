#include "bench/filtered_tiles.hpp"

#include <algorithm>
#include <bit>

namespace meetc::bench {

filtered_tiles::filtered_tiles(const predicate_info &predicate, rung precision, const float *rows_a,
                               std::size_t count_a, const float *rows_b, std::size_t count_b)
    : filter_(*predicate.a->filter), rung_(predicate.decide[static_cast<int>(precision)]), rows_a_(rows_a),
      rows_b_(rows_b), fields_a_(static_cast<std::size_t>(predicate.a->fields)),
      fields_b_(static_cast<std::size_t>(predicate.b->fields)), floats_(static_cast<std::size_t>(filter_.floats)),
      singles_(count_a * floats_), tiles_((count_b + filter_tile) * floats_) {
  filter_extent frame;
  predicate.b->filter->widen(rows_b, count_b, frame);
  filter_.singles(frame, rows_a, count_a, singles_.data());
  predicate.b->filter->tiles(frame, rows_b, count_b, tiles_.data());
}

void filtered_tiles::decide(std::size_t i, std::size_t from, std::size_t n, answer *out) const {
  constexpr std::size_t most = 64; // tiles at a time
  std::fill_n(out, n, answer::no);
  near_tile near[most];
  index_pair pairs[most * filter_tile];
  answer answers[most * filter_tile];
  for (std::size_t at = 0; at < n; at += most * filter_tile) {
    const std::size_t count = std::min(most, (n - at + filter_tile - 1) / filter_tile);
    const near_tile *const end =
        filter_.near(singles_.data() + i * floats_, tiles_.data() + (from + at) * floats_, count, near);
    std::size_t size = 0;
    for (const near_tile *t = near; t < end; ++t)
      for (std::uint32_t left = t->elements; left != 0; left &= left - 1) {
        const std::size_t k =
            at + std::size_t{t->index} * filter_tile + static_cast<std::size_t>(std::countr_zero(left));
        pairs[size] = {0, static_cast<std::uint32_t>(k)};
        size += k < n;
      }
    if (size == 0)
      continue;
    rung_(rows_a_ + i * fields_a_, rows_b_ + from * fields_b_, pairs, size, answers);
    for (std::size_t k = 0; k < size; ++k)
      out[pairs[k].b] = answers[k];
  }
}

} // namespace meetc::bench
