#include "bench/harness/chart.hpp"

#include "bench/harness/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::bench {

namespace {

// Writes sizes in thousands, as the paper does.
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
  case 8:
    return "100M";
  default:
    return exponent >= 0 && exponent <= 2   ? fmt::format("{}", std::lround(std::pow(10, exponent)))
           : exponent < 0 && exponent >= -3 ? fmt::format("{:.{}f}", std::pow(10, exponent), -exponent)
                                            : fmt::format("1e{}", exponent);
  }
}

struct span_of_tens {
  int low = 0, high = 1;
};

bool drawable(const std::pair<double, double> &p) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  return positive(p.first) && positive(p.second);
}

template <class Get> span_of_tens span_of(const chart &c, const Get &get) {
  double least = INFINITY, most = 0;
  for (const curve &k : c.curves)
    for (const auto &p : k.points)
      if (drawable(p)) {
        least = std::min(least, get(p));
        most = std::max(most, get(p));
      }
  if (most == 0)
    return {};
  span_of_tens s{static_cast<int>(std::floor(std::log10(least))), static_cast<int>(std::ceil(std::log10(most)))};
  s.high = std::max(s.high, s.low + 1);
  return s;
}

std::string hex(picture::colour c) {
  return fmt::format("'#{:02x}{:02x}{:02x}'", c.r, c.g, c.b);
}

// An axis with a label at each power of ten; where `fine`, with marks between them.
std::string axis(char name, const span_of_tens &s, bool fine) {
  std::string marks;
  for (int e = s.low; e <= s.high; ++e) {
    marks += fmt::format("{}{} 1e{}", marks.empty() ? "" : ", ", gnuplot_string(power_of_ten(e)), e);
    for (int k = 2; fine && k < 10 && e < s.high; ++k)
      marks += fmt::format(", '' {}e{} 1", k, e); // 1 is the second order of marks
  }
  // The range is a little wider than the powers, because gnuplot leaves out an end's label that it rounds to the wrong
  // side.
  return fmt::format("set {0}range [0.99999e{1}:1.00001e{2}]\nset {0}tics ({3})\n", name, s.low, s.high, marks);
}

} // namespace

std::string script_of(const chart &c, int width, int height) {
  std::string out = fmt::format("set encoding utf8\n"
                                "set terminal pngcairo noenhanced size {},{} background '#fcfcfb' font 'Sans,{}'\n",
                                width, height, std::max(7, width / 90));
  out += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", gnuplot_string(c.title), gnuplot_string(c.x_label),
                     gnuplot_string(c.y_label));
  out += "set logscale xy\nset border 3\nset tics nomirror out\n"
         "set key above left vertical Left reverse maxcols 1 samplen 3\n"
         "set grid xtics mxtics ytics lt 1 lc rgb '#dee1e4', lt 1 lc rgb '#f0f1f2'\n";
  out += axis('x', span_of(c, [](const auto &p) { return p.first; }), true);
  out += axis('y', span_of(c, [](const auto &p) { return p.second; }), false);
  std::string curves;
  for (std::size_t i = 0; i < c.curves.size(); ++i) {
    const curve &k = c.curves[i];
    out += fmt::format("$curve_{} << END\n", i);
    for (const auto &p : k.points)
      if (drawable(p))
        out += fmt::format("{:.17g} {:.17g}\n", p.first, p.second);
      else
        out += "NaN NaN\n";
    out += "END\n";
    curves += fmt::format("{}$curve_{} using 1:2 with linespoints linewidth 2 pointtype 7 pointsize 1 linecolor rgb {} "
                          "title {}",
                          curves.empty() ? "" : ", ", i, hex(k.ink), gnuplot_string(k.name));
  }
  return out + "plot " + (curves.empty() ? "NaN notitle" : curves) + "\n";
}

void write_chart(const std::filesystem::path &to, const chart &c, int width, int height) {
  run_gnuplot(script_of(c, width, height), to);
}

} // namespace meetc::bench
