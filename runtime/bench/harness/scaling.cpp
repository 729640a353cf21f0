#include "meet/bench/harness/scaling.hpp"

#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meetc::bench {

power_fit fit_power(const std::vector<double> &sizes, const std::vector<double> &counts, double expected,
                    double scatter) {
  power_fit fit;
  fit.expected = expected;
  fit.scatter = scatter;
  fit.exponent = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, y, level; // level: log of count / n^expected
  for (std::size_t i = 0; i < std::min(sizes.size(), counts.size()); ++i)
    if (sizes[i] > 0 && counts[i] > 0) {
      x.push_back(std::log(sizes[i]));
      y.push_back(std::log(counts[i]));
      level.push_back(y.back() - expected * x.back());
    }
  if (x.size() < 2)
    return fit;
  double mean = 0;
  for (const double v : x)
    mean += v / static_cast<double>(x.size());
  double absolute = 0, square = 0, product = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    absolute += std::abs(x[i] - mean);
    square += (x[i] - mean) * (x[i] - mean);
    product += (x[i] - mean) * y[i];
  }
  if (square == 0)
    return fit;
  fit.exponent = product / square;
  fit.tolerance = std::log1p(scatter) * absolute / square;
  fit.holds = std::abs(fit.exponent - expected) <= fit.tolerance;
  std::vector<double> sorted = level;
  std::sort(sorted.begin(), sorted.end());
  const double median = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (const double off = std::expm1(level[i] - median); std::abs(off) >= std::abs(fit.worst)) {
      fit.worst = off;
      fit.worst_size = std::exp(x[i]);
    }
  return fit;
}

std::string in_words(const power_fit &fit) {
  if (std::isnan(fit.exponent))
    return "too few rows with hits to fit an exponent";
  const std::string row = app::grouped(static_cast<std::uint64_t>(std::llround(fit.worst_size)));
  const std::string farthest = std::abs(fit.worst) < 0.01
                                   ? "no row is off it by 1 %"
                                   : fmt::format("farthest from it is the row of {}, {:.0f} % {}", row,
                                                 std::abs(100 * fit.worst), fit.worst < 0 ? "below" : "above");
  const double exponent = std::abs(fit.exponent) < 5e-4 ? 0 : fit.exponent; // avoids "-0.000"
  return fmt::format("exponent {:.3f}, expected {} ± {:.3f}: the scaling {}; {}", exponent, fit.expected, fit.tolerance,
                     fit.holds ? "holds" : "does not hold", farthest);
}

app::json as_json(const power_fit &fit) {
  const app::json expected = app::number(fmt::format("{}", fit.expected));
  if (std::isnan(fit.exponent))
    return {{"law", expected}, {"exponent", nullptr}, {"holds", false}};
  return {{"law", expected},
          {"exponent", app::with_decimals(fit.exponent, 6)},
          {"tolerance", app::with_decimals(fit.tolerance, 6)},
          {"worst", app::with_decimals(fit.worst, 6)},
          {"holds", fit.holds}};
}

} // namespace meetc::bench
