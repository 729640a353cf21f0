// bench/harness/measure.hpp: CPU times that can be compared even though the machine does other things.
//
// Problem: on a shared machine the same work can take twice as long a minute later, so times in different rows of a
// table cannot be divided by each other.
// Method: a yardstick, a fixed piece of work of some milliseconds on one core, runs before and after each run of what
// is measured, and a run's time is kept as a multiple of it. The median of several runs counts. Time is that of the
// calling thread on its core, so the work must not leave that thread. Several pieces of work take turns. Short ones are
// repeated until they last about as long as the yardstick.
// Limits: times are multiples of the yardstick's, for ratios within one process. seconds() turns them into seconds only
// for a comparison with a GPU.
#ifndef MEETC_BENCH_HARNESS_MEASURE_HPP
#define MEETC_BENCH_HARNESS_MEASURE_HPP

#include <functional>
#include <vector>

namespace meetc::bench {

double median(std::vector<double> values); // 0 for none

class yardstick {
public:
  yardstick();
  // The median time of each, in yardsticks.
  std::vector<double> measure(const std::vector<std::function<void()>> &works, int runs);
  // The duration of this many yardsticks, each with the median length so far.
  double seconds(double yardsticks) const;

private:
  double once(); // runs the yardstick and returns its seconds
  std::vector<float> balls_;
  std::vector<double> lengths_;
  unsigned kept_ = 0; // a result that keeps the compiler from removing the work
};

} // namespace meetc::bench

#endif
