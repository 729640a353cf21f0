// bench/harness/turns.hpp: times of several works that take turns.
//
// Problem: on a shared machine the same work can take twice as long a minute later, so times that were taken one after the
// other cannot be divided by each other.
// Method: all works run once in each repetition, one after the other, so a slow minute meets all of them, and the median of
// each work's times counts. Short works are repeated within one measurement. Where a repetition is long, there are fewer of
// them: the number is part of the result. Times of different calls are compared as multiples of a fixed work that takes part
// in each of them (reference_work).
#ifndef MEETC_BENCH_HARNESS_TURNS_HPP
#define MEETC_BENCH_HARNESS_TURNS_HPP

#include "meet/bench/harness/clock.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace meetc::bench {

using works = std::vector<std::function<void()>>;

struct turns {
  int repetitions = 21;        // after one that does not count
  double most_seconds = 60;    // for all works together; then there are fewer repetitions, but not fewer than 3
  double least_seconds = 2e-3; // of one measurement; 0: each work runs once in it
};

struct times {
  std::vector<double> seconds; // the median of each work
  int repetitions = 0;
};

times take_turns(clock &by, const works &all, const turns &how);

double median(std::vector<double> values); // 0 for none

// The medians of N figures that each run reports, over `runs` runs after one that does not count.
template <std::size_t N, class Run> std::array<double, N> medians_of(int runs, const Run &run) {
  std::array<std::vector<double>, N> all;
  for (int i = 0; i <= runs; ++i) {
    const std::array<double, N> figures = run();
    for (std::size_t k = 0; k < N && i > 0; ++k)
      all[k].push_back(figures[k]);
  }
  std::array<double, N> out{};
  std::transform(all.begin(), all.end(), out.begin(), [](std::vector<double> &v) { return median(std::move(v)); });
  return out;
}

// A fixed piece of work of some milliseconds on one core.
std::function<void()> reference_work();

} // namespace meetc::bench

#endif
