#include "bench/every_pair.hpp"

#include "core/threads.hpp"

#include <algorithm>
#include <mutex>

namespace meetc::bench {

namespace {

constexpr std::size_t most_rows_timed = 256;

} // namespace

every_pair_result measure_every_pair(std::size_t count_a, std::size_t count_b, const tile_test &exact,
                                     const std::vector<named_test> &tests, std::uint64_t timed_pairs,
                                     const interleaved_options &by) {
  every_pair_result r;
  r.of.resize(tests.size());
  r.pairs = static_cast<std::uint64_t>(count_a) * count_b;

  std::mutex adding;
  for_chunks(thread_count(0), count_b, most_tile_columns, [&](int, std::size_t from, std::size_t end) {
    std::vector<answer> truth, out;
    std::vector<every_pair_row> found(tests.size());
    std::uint64_t hits = 0;
    for (std::size_t i = 0; i < count_a; i += most_tile_rows) {
      const pair_tile tile{i, std::min(most_tile_rows, count_a - i), from, end - from};
      truth.resize(tile.rows * tile.n), out.resize(tile.rows * tile.n);
      exact(tile, truth.data());
      hits += static_cast<std::uint64_t>(std::count(truth.begin(), truth.end(), answer::yes));
      for (std::size_t t = 0; t < tests.size(); ++t) {
        tests[t].test(tile, out.data());
        if (out == truth) // most tiles: what follows is slow
          continue;
        for (std::size_t k = 0; k < out.size(); ++k) {
          found[t].false_hits += out[k] == answer::yes && truth[k] != answer::yes;
          found[t].missed += out[k] != answer::yes && truth[k] == answer::yes;
        }
      }
    }
    const std::lock_guard lock(adding);
    r.hits += hits;
    for (std::size_t t = 0; t < tests.size(); ++t) {
      r.of[t].false_hits += found[t].false_hits;
      r.of[t].missed += found[t].missed;
    }
  });
  for (every_pair_row &row : r.of)
    row.hits = r.hits + row.false_hits - row.missed;

  const auto parts = [](std::size_t n, std::size_t of) { return (n + of - 1) / of; };
  const std::size_t bands = parts(count_a, most_tile_rows), tiles = parts(count_b, most_tile_columns);
  const std::size_t step = parts(bands, most_rows_timed / most_tile_rows);
  const std::size_t pairs_a_tile = std::min(count_a, most_rows_timed) * std::min(count_b, most_tile_columns);
  const std::size_t tiles_wanted = std::clamp<std::size_t>(timed_pairs / pairs_a_tile, 1, tiles);
  std::vector<answer> out(most_tile_rows * most_tile_columns);
  std::uint64_t timed = 0;
  const auto run = [&](const tile_test &test) {
    timed = 0;
    for (std::size_t t = 0; t < tiles_wanted; ++t) {
      const std::size_t from = t * tiles / tiles_wanted * most_tile_columns;
      for (std::size_t band = 0; band < bands; band += step) {
        const std::size_t row = band * most_tile_rows;
        const pair_tile tile{row, std::min(most_tile_rows, count_a - row), from,
                             std::min(most_tile_columns, count_b - from)};
        test(tile, out.data());
        timed += tile.rows * tile.n;
      }
    }
  };
  std::vector<std::function<void()>> works;
  for (const named_test &t : tests)
    works.emplace_back([&run, &t] { run(t.test); });
  const interleaved_times times = measure_interleaved(works, by);
  for (std::size_t t = 0; t < tests.size(); ++t)
    r.of[t].seconds_a_pair = times.seconds[t] / static_cast<double>(timed);
  r.repetitions = times.repetitions;
  return r;
}

} // namespace meetc::bench
