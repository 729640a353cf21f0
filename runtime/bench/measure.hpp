// bench/measure.hpp: CPU times that can be compared though the machine does other things too.
//
// Problem: on a shared machine the same work takes twice as long a minute later, so times of different rows
// of a table cannot be divided by each other. Method: a yardstick, a fixed piece of work of some milliseconds
// on one core, is run before and after each run of what is measured, and a run's time is kept as a multiple
// of it; of several runs the median is taken. Time is the calling thread's on its core, so the work must not
// leave that thread. Several pieces of work take turns. Short ones are repeated until they last about as long
// as the yardstick. Limits: times are multiples of the yardstick's, for ratios within one process; seconds()
// turns them into seconds only to be set against a GPU's.
#ifndef MEETC_BENCH_MEASURE_HPP
#define MEETC_BENCH_MEASURE_HPP

#include <functional>
#include <vector>

namespace meetc::bench {

double median(std::vector<double> values); // 0 for none

class yardstick {
public:
  yardstick();
  // The median time of each, in yardsticks.
  std::vector<double> measure(const std::vector<std::function<void()>> &works, int runs);
  // So many yardsticks, each of the median length so far.
  double seconds(double yardsticks) const;

private:
  double once(); // runs it; seconds
  std::vector<float> balls_;
  std::vector<double> lengths_;
  unsigned kept_ = 0; // so that the work is done
};

} // namespace meetc::bench

#endif
