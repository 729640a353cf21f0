// bench/harness/chart.hpp: curves of positive numbers over sizes, with both axes by powers of ten, as a PNG file.
//
// Limits: points that are not positive and finite are left out.
#ifndef MEETC_BENCH_HARNESS_CHART_HPP
#define MEETC_BENCH_HARNESS_CHART_HPP

#include "meet/bench/harness/plot.hpp"
#include "meet/picture/palette.hpp"

#include <string>
#include <utility>
#include <vector>

namespace meetc::bench {

namespace curve_colours {
inline constexpr picture::colour cpu = picture::palette::series[0], red = picture::palette::series[1], // for Möller's
    gpu = picture::palette::series[2], search = picture::palette::series[3]; // test, as in the paper
} // namespace curve_colours

struct curve {
  std::string name;
  picture::colour ink;
  std::vector<std::pair<double, double>> points = {}; // sorted by x
};

struct chart {
  std::string title, x_label, y_label;
  std::vector<curve> curves;
};

// Sizes are in pixels.
plot plot_of(const chart &c, int width, int height);

} // namespace meetc::bench

#endif
