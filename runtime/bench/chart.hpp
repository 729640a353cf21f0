// app/bench/chart.hpp: curves of positive numbers over sizes, both axes by powers of ten, as a picture.
//
// Limits: points that are not positive and finite are left out. Text is the pictures' own bitmap font.
#ifndef MEETC_APP_BENCH_CHART_HPP
#define MEETC_APP_BENCH_CHART_HPP

#include "picture/picture.hpp"

#include <string>
#include <utility>
#include <vector>

namespace meetc::app {

namespace palette {
inline constexpr colour curve_red{206, 46, 38}; // Moeller's, as in the paper
inline constexpr colour curve_cpu{36, 92, 168};
inline constexpr colour curve_search{120, 128, 138};
inline constexpr colour curve_gpu{34, 142, 76};
} // namespace palette

struct curve {
  std::string name;
  colour ink;
  std::vector<std::pair<double, double>> points; // by x
};

struct chart {
  std::string title, x_label, y_label;
  std::vector<curve> curves;
};

image draw(const chart &c, int width, int height);

} // namespace meetc::app

#endif
