#include "meet/bench/harness/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::bench {

namespace {

bool drawable(const std::pair<double, double> &p) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  return positive(p.first) && positive(p.second);
}

// The powers of ten around the drawable points: lowest and highest, which differ.
template <class Get> std::pair<double, double> powers_around(const chart &c, const Get &get) {
  double least = INFINITY, most = 0;
  for (const curve &k : c.curves)
    for (const auto &p : k.points)
      if (drawable(p))
        least = std::min(least, get(p)), most = std::max(most, get(p));
  if (most == 0)
    return {0, 1};
  const double low = std::floor(std::log10(least));
  return {low, std::max(std::ceil(std::log10(most)), low + 1)};
}

} // namespace

plot plot_of(const chart &c, int width, int height) {
  const auto x = powers_around(c, [](const auto &p) { return p.first; }),
             y = powers_around(c, [](const auto &p) { return p.second; });
  std::vector<std::string> names, colours, points;
  for (const curve &k : c.curves) {
    names.push_back(k.name);
    colours.push_back(picture::hexadecimal(k.ink));
    points.emplace_back();
    for (const auto &p : k.points)
      points.back() += drawable(p) ? fmt::format("{:.17g} {:.17g}\n", p.first, p.second) : "NaN NaN\n";
  }
  plot out("chart");
  out.set("width", width).set("height", height);
  out.set("title_words", c.title).set("x_words", c.x_label).set("y_words", c.y_label);
  out.set("x_low", x.first).set("x_high", x.second).set("y_low", y.first).set("y_high", y.second);
  out.set("curves", static_cast<double>(c.curves.size())).list("names", names).list("colours", colours);
  out.data("points", points);
  return out;
}

} // namespace meetc::bench
