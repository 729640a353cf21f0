// bench/harness/chart.hpp: curves of positive numbers over sizes, with both axes by powers of ten, as a PNG file.
//
// Limits: points that are not positive and finite are left out.
#ifndef MEETC_BENCH_HARNESS_CHART_HPP
#define MEETC_BENCH_HARNESS_CHART_HPP

#include "meet/bench/harness/plot.hpp"
#include "meet/picture/image.hpp"

#include <string>
#include <utility>
#include <vector>

namespace meetc::bench {

namespace curve_colours {
inline constexpr picture::colour red{206, 46, 38}; // for Möller's test, as in the paper
inline constexpr picture::colour cpu{36, 92, 168};
inline constexpr picture::colour search{120, 128, 138};
inline constexpr picture::colour gpu{34, 142, 76};
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
