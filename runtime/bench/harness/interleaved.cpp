#include "bench/harness/interleaved.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace meetc::bench {

namespace {

constexpr int least_repetitions = 3;

double now(int threads) {
  timespec t{};
  ::clock_gettime(threads == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

} // namespace

double lower_quartile(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

interleaved_times measure_interleaved(const std::vector<std::function<void()>> &works, const interleaved_options &by) {
  std::vector<int> times;
  double all = 0;
  for (const auto &work : works) { // which also warms up
    const double start = now(by.threads);
    work();
    const double took = std::max(1e-7, now(by.threads) - start);
    times.push_back(static_cast<int>(std::clamp(std::ceil(by.least_seconds / took), 1.0, 1e5)));
    all += took * times.back();
  }
  interleaved_times out;
  const double affordable = std::max(by.most_seconds / all, 1.0 * least_repetitions);
  out.repetitions = static_cast<int>(std::min(1.0 * by.repetitions, affordable));
  std::vector<std::vector<double>> measured(works.size());
  for (int r = 0; r < out.repetitions; ++r)
    for (std::size_t w = 0; w < works.size(); ++w) {
      const double start = now(by.threads);
      for (int i = 0; i < times[w]; ++i)
        works[w]();
      measured[w].push_back((now(by.threads) - start) / times[w]);
    }
  for (auto &m : measured)
    out.seconds.push_back(lower_quartile(std::move(m)));
  return out;
}

} // namespace meetc::bench
