// bench/harness/interleaved.hpp: times of several works that take turns, for ratios within one run.
//
// Problem: on a shared machine the same work can take twice as long a minute later. A yardstick (bench/harness/measure.hpp)
// corrects works of one thread alone; builds and queries of other libraries may use threads of their own.
// Method: all works run once in each repetition, one after the other, so a slow minute meets all of them; the lower
// quartile of each work's times counts, since disturbance only adds time. With one thread, time is that of the whole
// process on its cores, in which other processes do not count; with more it is wall-clock time. Short works are repeated
// within one measurement. Where a repetition is long, there are fewer of them: the number is part of the result.
#ifndef MEETC_BENCH_HARNESS_INTERLEAVED_HPP
#define MEETC_BENCH_HARNESS_INTERLEAVED_HPP

#include <functional>
#include <vector>

namespace meetc::bench {

struct interleaved_options {
  int repetitions = 21;
  int threads = 1;             // what the works use
  double most_seconds = 60;    // for all works together; then there are fewer repetitions, but not fewer than 3
  double least_seconds = 2e-3; // of one measurement
};

struct interleaved_times {
  std::vector<double> seconds; // the lower quartile for each work
  int repetitions = 0;
};

interleaved_times measure_interleaved(const std::vector<std::function<void()>> &works, const interleaved_options &by);

double lower_quartile(std::vector<double> values); // 0 for none

} // namespace meetc::bench

#endif
