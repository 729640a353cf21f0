// bench/every_pair.hpp: tests of every pair of two sets, without boxes: their times, and how many answers are wrong.
//
// Method: each test takes a few elements of a against a tile of b, and the tiles are the same for all tests. Times are
// taken on a part of the pairs, spread evenly over both sets; answers are compared with exact ones on all pairs, on all
// cores.
#ifndef MEETC_BENCH_EVERY_PAIR_HPP
#define MEETC_BENCH_EVERY_PAIR_HPP

#include "bench/interleaved.hpp"
#include "meetc/support.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meetc::bench {

// Elements of a, `rows` of them from `row` on, against n elements of b from `from` on.
struct pair_tile {
  std::size_t row, rows, from, n;
};
inline constexpr std::size_t most_tile_rows = 8, most_tile_columns = 512; // what is read of b fits into the first cache

// Writes rows * n answers, those of one element of a after another. It may run on several threads.
using tile_test = std::function<void(const pair_tile &tile, answer *out)>;
// The same by a function of one row at a time: (i, from, n, out).
template <class F> tile_test row_by_row(F f) {
  return [f](const pair_tile &t, answer *out) {
    for (std::size_t r = 0; r < t.rows; ++r)
      f(t.row + r, t.from, t.n, out + r * t.n);
  };
}

struct named_test {
  std::string name;
  tile_test test;
};

struct every_pair_row {
  double seconds_a_pair = 0;
  std::uint64_t hits = 0, false_hits = 0, missed = 0; // of all pairs
};

struct every_pair_result {
  std::vector<every_pair_row> of;    // one for each test
  std::uint64_t pairs = 0, hits = 0; // of the exact answers
  int repetitions = 0;
};

every_pair_result measure_every_pair(std::size_t count_a, std::size_t count_b, const tile_test &exact,
                                     const std::vector<named_test> &tests, std::uint64_t timed_pairs,
                                     const interleaved_options &by);

} // namespace meetc::bench

#endif
