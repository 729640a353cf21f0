#include "meet/app/input/made_sets.hpp"
#include "meet/bench/scenes/scene_sets.hpp"
#include "meet/bench/scenes/scenes.hpp"
#include "meet/bodies/meshes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace meetc::bench {

namespace {

constexpr std::size_t ball_fields = 4, segment_fields = 6;

// The radius at which each of n balls in [-1, 1)^3 touches about this many of n others.
double radius_for(double touching, std::size_t n) {
  return std::cbrt(touching * 3 / (4 * std::numbers::pi * static_cast<double>(n)));
}
std::vector<float> balls(std::size_t n, std::uint64_t seed, double radius) {
  return bodies::sphere_cloud(n, seed, 0.8 * radius, 1.2 * radius);
}

// Changes both sets of a pair.
template <class Change> auto balls_changed(const catalogue &all, std::size_t n, Change &&change) {
  return [&all, n, change] {
    std::pair<io::element_set, io::element_set> out;
    for (const bool first : {true, false}) {
      std::vector<float> rows = balls(n, first ? 1 : 2, radius_for(1.1, n));
      change(rows, first);
      (first ? out.first : out.second) = app::of_rows(all, "sphere", std::move(rows));
    }
    return out;
  };
}

} // namespace

std::vector<scene> hard_scenes(const scene_source &from) {
  const catalogue &all = from.all;
  const std::size_t n = std::size_t{1} << (from.quick ? 12 : 20);
  std::vector<scene> out;
  const auto add = [&](const char *what, auto &&change, bool even = false) {
    out.push_back({fmt::format("{} balls: {}", n, what), "ball_ball", balls_changed(all, n, change), false, even});
  };
  add(
      "even", [](std::vector<float> &, bool) {}, true);
  add("one of each set at 1e30", [](std::vector<float> &rows, bool) { rows[0] = 1e30F; });
  add("all but the first eight in 1e-6 of the box", [](std::vector<float> &rows, bool) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (i >= 8 * ball_fields)
        rows[i] *= 1e-6F;
      else if (i % ball_fields < 3)
        rows[i] = (i / ball_fields >> i % ball_fields & 1) != 0 ? 1.0F : -1.0F;
  });
  // Evenly spread logarithms, from 1/300 to 10/3 of the radius of the even balls.
  add("radii of 1 : 1000", [](std::vector<float> &rows, bool) {
    const std::size_t count = rows.size() / ball_fields;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i * 0x9e3779b97f4a7c15 >> 40) * 0x1p-24;
      rows[i * ball_fields + 3] *= static_cast<float>(std::pow(1000, share) / 300);
    }
  });
  add("each four times", [](std::vector<float> &rows, bool) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = rows[i / ball_fields / 4 * 4 * ball_fields + i % ball_fields];
  });
  const auto with_segments = [&](const char *what, std::size_t every, bool even) {
    out.push_back({fmt::format("{} balls x segments: {}", n, what), "ball_segment",
                   [&all, n, every] {
                     const double radius = radius_for(1.1, n);
                     std::vector<float> rows = bodies::segment_cloud(n, 3, radius);
                     const std::vector<float> longer = bodies::segment_cloud(n, 3, 2);
                     for (std::size_t i = 0; every > 0 && i < rows.size(); ++i)
                       if (i / segment_fields % every == 0)
                         rows[i] = longer[i];
                     return std::pair(app::of_rows(all, "sphere", balls(n, 1, radius)),
                                      app::of_rows(all, "segment", std::move(rows)));
                   },
                   false, even});
  };
  with_segments("even", 0, true);
  with_segments("one in a hundred as long as the box", 100, false);
  return out;
}

} // namespace meetc::bench
