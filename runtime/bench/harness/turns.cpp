#include "meet/bench/harness/turns.hpp"

#include "meet/bench/baselines/baselines.hpp"
#include "meet/bodies/meshes.hpp"

#include <cmath>
#include <memory>

namespace meetc::bench {

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

times take_turns(clock &by, const works &all, const turns &how) {
  constexpr int least_repetitions = 3;
  const auto seconds_of = [&by](const std::function<void()> &work, int times) {
    by.start();
    for (int i = 0; i < times; ++i)
      work();
    return by.stop() / times;
  };
  std::vector<int> times_of;
  double round = 0;
  for (const auto &work : all) { // which also warms up
    const double took = std::max(1e-7, seconds_of(work, 1));
    times_of.push_back(static_cast<int>(std::clamp(std::ceil(how.least_seconds / took), 1.0, 1e5)));
    round += took * times_of.back();
  }
  times out;
  const double affordable = std::max(how.most_seconds / round, 1.0 * least_repetitions);
  out.repetitions = static_cast<int>(std::min(1.0 * how.repetitions, affordable));
  std::vector<std::vector<double>> measured(all.size());
  for (int r = 0; r < out.repetitions; ++r)
    for (std::size_t w = 0; w < all.size(); ++w)
      measured[w].push_back(seconds_of(all[w], times_of[w]));
  for (auto &m : measured)
    out.seconds.push_back(median(std::move(m)));
  return out;
}

std::function<void()> reference_work() {
  constexpr std::size_t balls = 1500;
  struct state {
    std::vector<float> rows = bodies::sphere_cloud(balls, 1, 0.02, 0.08);
    unsigned kept = 0; // a result that keeps the compiler from removing the work
  };
  return [s = std::make_shared<state>()] {
    for (std::size_t i = 0; i < s->rows.size(); i += 4)
      for (std::size_t j = 0; j < s->rows.size(); j += 4)
        s->kept += baselines::balls(s->rows.data() + i, s->rows.data() + j) ? 1 : 0;
  };
}

} // namespace meetc::bench
