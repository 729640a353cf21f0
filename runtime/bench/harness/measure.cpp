#include "bench/harness/measure.hpp"

#include "bench/baselines/baselines.hpp"
#include "bodies/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace meetc::bench {

namespace {

constexpr std::size_t balls = 1500;
constexpr double least_share = 0.5; // the least duration of a run, as a share of a yardstick

// CPU time of this thread, in which other processes do not count.
double now() {
  timespec t{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double seconds_of(const std::function<void()> &work) {
  const double start = now();
  work();
  return now() - start;
}

} // namespace

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

yardstick::yardstick() : balls_(bodies::sphere_cloud(balls, 1, 0.02, 0.08)) {
  once(); // warms up
  lengths_.push_back(once());
}

double yardstick::once() {
  return seconds_of([this] {
    for (std::size_t i = 0; i < balls_.size(); i += 4)
      for (std::size_t j = 0; j < balls_.size(); j += 4)
        kept_ += baselines::balls(balls_.data() + i, balls_.data() + j) ? 1 : 0;
  });
}

std::vector<double> yardstick::measure(const std::vector<std::function<void()>> &works, int runs) {
  std::vector<int> repeats;
  for (const std::function<void()> &work : works) {
    const double needed = least_share * median(lengths_);
    repeats.push_back(static_cast<int>(std::clamp(std::ceil(needed / std::max(1e-7, seconds_of(work))), 1.0, 1e5)));
  }
  std::vector<std::vector<double>> times(works.size());
  double before = once();
  for (int run = 0; run < runs; ++run)
    for (std::size_t w = 0; w < works.size(); ++w) {
      const double took = seconds_of([&] {
        for (int i = 0; i < repeats[w]; ++i)
          works[w]();
      });
      const double after = once();
      times[w].push_back(took / repeats[w] / ((before + after) / 2));
      lengths_.push_back(after);
      before = after;
    }
  std::vector<double> out;
  for (std::vector<double> &t : times)
    out.push_back(median(std::move(t)));
  return out;
}

double yardstick::seconds(double yardsticks) const {
  return yardsticks * median(lengths_);
}

} // namespace meetc::bench
