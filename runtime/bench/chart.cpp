#include "bench/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::app {

namespace {

constexpr colour paper_white{252, 252, 251}, grid{222, 225, 228}, fine_grid{240, 241, 242};

// Sizes in thousands as the paper writes them.
std::string power_of_ten(int exponent) {
  switch (exponent) {
  case 3:
    return "1K";
  case 4:
    return "10K";
  case 5:
    return "100K";
  case 6:
    return "1M";
  case 7:
    return "10M";
  default:
    return exponent >= 0 && exponent <= 2   ? fmt::format("{}", std::lround(std::pow(10, exponent)))
           : exponent < 0 && exponent >= -3 ? fmt::format("{:.{}f}", std::pow(10, exponent), -exponent)
                                            : fmt::format("1e{}", exponent);
  }
}

struct span_of_tens {
  int low = 0, high = 1;
};

bool drawable(double v) {
  return std::isfinite(v) && v > 0;
}

template <class Get> span_of_tens span_of(const chart &c, const Get &get) {
  double least = INFINITY, most = 0;
  for (const curve &k : c.curves)
    for (const auto &p : k.points)
      if (drawable(p.first) && drawable(p.second)) {
        least = std::min(least, get(p));
        most = std::max(most, get(p));
      }
  if (most == 0)
    return {};
  span_of_tens s{static_cast<int>(std::floor(std::log10(least))), static_cast<int>(std::ceil(std::log10(most)))};
  s.high = std::max(s.high, s.low + 1);
  return s;
}

struct canvas {
  image picture;

  void blend(int x, int y, colour ink, double share) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height || share <= 0)
      return;
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    const std::uint8_t to[3] = {ink.r, ink.g, ink.b};
    for (std::size_t k = 0; k < 3; ++k)
      picture.rgb[i + k] = static_cast<std::uint8_t>(
          std::lround(picture.rgb[i + k] + std::min(1.0, share) * (to[k] - picture.rgb[i + k])));
  }
  // All pixels within `radius` of the segment, the rim softened over a pixel. A point where both ends are
  // one.
  void stroke(double x0, double y0, double x1, double y1, double radius, colour ink) {
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    for (int y = static_cast<int>(std::min(y0, y1) - radius - 1); y <= std::max(y0, y1) + radius + 1; ++y)
      for (int x = static_cast<int>(std::min(x0, x1) - radius - 1); x <= std::max(x0, x1) + radius + 1; ++x) {
        const double t = square > 0 ? std::clamp(((x - x0) * dx + (y - y0) * dy) / square, 0.0, 1.0) : 0.0;
        blend(x, y, ink, radius + 0.5 - std::hypot(x - x0 - t * dx, y - y0 - t * dy));
      }
  }
  void rule(int x0, int y0, int x1, int y1, colour ink) {
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        blend(x, y, ink, 1);
  }
};

} // namespace

image draw(const chart &c, int width, int height) {
  const int w = std::clamp(width, 320, 8192), h = std::clamp(height, 240, 8192), scale = std::max(1, w / 500);
  canvas out{{w, h, {}}};
  for (int i = 0; i < w * h; ++i)
    out.picture.rgb.insert(out.picture.rgb.end(), {paper_white.r, paper_white.g, paper_white.b});
  const int letter = 6 * scale, line = 11 * scale;
  const int left = 8 * letter, right = w - 3 * letter, bottom = h - 3 * line;
  const int top = static_cast<int>(2 * line + static_cast<int>(c.curves.size() + 1) * line);
  const span_of_tens xs = span_of(c, [](const auto &p) { return p.first; });
  const span_of_tens ys = span_of(c, [](const auto &p) { return p.second; });
  const auto x_at = [&](double v) { return left + (right - left) * (std::log10(v) - xs.low) / (xs.high - xs.low); };
  const auto y_at = [&](double v) { return bottom - (bottom - top) * (std::log10(v) - ys.low) / (ys.high - ys.low); };
  const auto text = [&](int x, int y, const std::string &words, colour ink) {
    draw_text(out.picture, x, y, words, scale, ink);
  };

  for (int e = xs.low; e <= xs.high; ++e) {
    const int x = static_cast<int>(std::lround(x_at(std::pow(10, e))));
    for (int k = 2; k < 10 && e < xs.high; ++k) {
      const int fine = static_cast<int>(std::lround(x_at(k * std::pow(10, e))));
      out.rule(fine, top, fine, bottom, fine_grid);
    }
    out.rule(x, top, x, bottom, grid);
    const std::string label = power_of_ten(e);
    text(x - letter * static_cast<int>(label.size()) / 2, bottom + scale * 4, label, palette::ink);
  }
  for (int e = ys.low; e <= ys.high; ++e) {
    const int y = static_cast<int>(std::lround(y_at(std::pow(10, e))));
    out.rule(left, y, right, y, grid);
    const std::string label = power_of_ten(e);
    text(left - letter * static_cast<int>(label.size()) - scale * 3, y - 3 * scale, label, palette::ink);
  }
  out.rule(left, top, left + scale - 1, bottom, palette::ink);
  out.rule(left, bottom - scale + 1, right, bottom, palette::ink);
  text(letter, scale * 5, c.title, palette::ink);
  text(letter, top - line, c.y_label, palette::ink);
  text(right - letter * static_cast<int>(c.x_label.size()), bottom + line + scale * 5, c.x_label, palette::ink);

  int row = 0;
  for (const curve &k : c.curves) {
    const int y = 2 * line + row++ * line;
    out.stroke(left, y + 3 * scale, left + 4 * letter, y + 3 * scale, scale, k.ink);
    text(left + 5 * letter, y, k.name, palette::ink);
    const std::pair<double, double> *before = nullptr;
    for (const auto &p : k.points) {
      if (!drawable(p.first) || !drawable(p.second))
        continue;
      out.stroke(x_at(p.first), y_at(p.second), x_at(p.first), y_at(p.second), 3 * scale, k.ink);
      if (before)
        out.stroke(x_at(before->first), y_at(before->second), x_at(p.first), y_at(p.second), scale, k.ink);
      before = &p;
    }
  }
  return out.picture;
}

} // namespace meetc::app
