#include "bench/filtered_tiles.hpp"

#include "core/affine_pairs.hpp"

#include <algorithm>
#include <bit>
#include <memory>

namespace meetc::bench {

namespace {

const float *floats_in(const owned_memory &m) {
  return static_cast<const float *>(m.get());
}

// The numbers of the filter by balls, as those of core/pair_filter.hpp.
struct balls_of_sets {
  owned_memory singles, tiles, groups;
};

} // namespace

tile_filter filter_by_balls(const predicate_info &predicate, const float *rows_a, std::size_t count_a,
                            const float *rows_b, std::size_t count_b) {
  const kind_filter &filter = *predicate.a->filter;
  const auto floats = static_cast<std::size_t>(filter.floats);
  const auto room = [floats](std::size_t elements) { return allocate(elements * floats * sizeof(float)); };
  const auto of = std::make_shared<balls_of_sets>(
      balls_of_sets{room(count_a), room(count_b + filter_tile), room(count_b / filter_tile + 1 + filter_tile)});
  filter_extent frame;
  predicate.b->filter->widen(rows_b, count_b, frame);
  filter.singles(frame, rows_a, count_a, static_cast<float *>(of->singles.get()));
  predicate.b->filter->tiles(frame, rows_b, count_b, static_cast<float *>(of->tiles.get()));
  predicate.b->filter->groups(frame, rows_b, count_b, static_cast<float *>(of->groups.get()));
  return [of, floats, near = filter.near](std::size_t i, std::size_t first, std::size_t count, near_tile *out) {
    return near(floats_in(of->singles) + i * floats, floats_in(of->groups) + first * floats,
                floats_in(of->tiles) + first * filter_tile * floats, count, out);
  };
}

tile_filter filter_by_signs(const predicate_info &predicate, const float *rows_a, std::size_t count_a,
                            const float *rows_b, std::size_t count_b) {
  const auto of = std::make_shared<affine_pairs>(predicate, rows_a, count_a, rows_b, count_b, 1);
  return [of](std::size_t i, std::size_t first, std::size_t count, near_tile *out) {
    return of->near(i, first, count, out);
  };
}

tile_test behind(tile_filter filter, const predicate_info &predicate, rung precision, const float *rows_a,
                 const float *rows_b) {
  return [filter = std::move(filter), decide = predicate.decide[static_cast<int>(precision)], rows_a, rows_b,
          fields_a = static_cast<std::size_t>(predicate.a->fields),
          fields_b = static_cast<std::size_t>(predicate.b->fields)](const pair_tile &tile, answer *out) {
    near_tile near[most_tile_columns / filter_tile];
    index_pair pairs[most_tile_rows * most_tile_columns];
    answer answers[most_tile_rows * most_tile_columns];
    std::fill_n(out, tile.rows * tile.n, answer::no);
    std::size_t size = 0;
    for (std::size_t r = 0; r < tile.rows; ++r) {
      const near_tile *const end =
          filter(tile.row + r, tile.from / filter_tile, (tile.n + filter_tile - 1) / filter_tile, near);
      for (const near_tile *t = near; t < end; ++t)
        for (std::uint32_t left = t->elements; left != 0; left &= left - 1) {
          const std::size_t k = std::size_t{t->index} * filter_tile + static_cast<std::size_t>(std::countr_zero(left));
          pairs[size] = {static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(k)};
          size += k < tile.n;
        }
    }
    if (size == 0)
      return;
    decide(rows_a + tile.row * fields_a, rows_b + tile.from * fields_b, pairs, size, answers);
    for (std::size_t k = 0; k < size; ++k)
      out[pairs[k].a * tile.n + pairs[k].b] = answers[k];
  };
}

} // namespace meetc::bench
