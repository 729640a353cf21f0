// The plot of `meet trade`: speed across, error upwards.
#include "bench/harness/gnuplot.hpp"
#include "bench/tables/trade/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace meetc::bench {

namespace {

// The predicates in the plot, by colour; all are in the table.
struct drawn {
  std::string_view predicate;
  const char *colour;
};
constexpr std::array subjects{drawn{"triangle_triangle", "#245ca8"}, drawn{"segment_triangle", "#22884c"},
                              drawn{"sphere_sphere", "#ce2e26"}, drawn{"ball_ball", "#c07a00"}};

// The methods, by shape.
struct mark {
  std::string_view method;
  int shape;
};
constexpr std::array all_marks{mark{"paper, fp32", 2},
                               mark{"fp32", 7},
                               mark{"fp64", 5},
                               mark{"fp64x2", 9},
                               mark{"exact", 6},
                               mark{"certified", 3},
                               mark{"certified, rounded", 8},
                               mark{"fp32, device", 13},
                               mark{"certified, device", 12},
                               mark{"fp16 filter, device", 11}};

// Where no answer is wrong, a mark lies on one of the lowest lines, each predicate on its own; where wrong answers are
// wrong by 0, on one of the lines above these.
constexpr double never = 1e-50, by_nothing = 1e-41, apart = 1e2, least = 1e-33, most = 1e2;

double height(const trade_cell &c, double distance) {
  return std::clamp(distance / c.size, least, most / 10);
}

double height(const trade_cell &c, const wrongness &w, std::size_t subject) {
  const double line = std::pow(apart, static_cast<double>(subject));
  return w.false_hits + w.missed == 0 ? never * line : w.farthest == 0 ? by_nothing * line : height(c, w.farthest);
}

// Those of the methods that were measured.
std::vector<mark> marks_in(const std::vector<trade_cell> &all) {
  std::vector<mark> out;
  for (const mark &m : all_marks)
    if (std::any_of(all.begin(), all.end(), [&m](const trade_cell &c) {
          return std::any_of(c.result.points.begin(), c.result.points.end(),
                             [&m](const trade_point &p) { return p.method.name == m.method; });
        }))
      out.push_back(m);
  return out;
}

std::string panel(const std::string &family, const std::vector<trade_cell> &all) {
  const std::vector<mark> marks = marks_in(all);
  std::string data, plots, title;
  int number = 0;
  const auto plot = [&plots](const std::string &how) { plots += (plots.empty() ? "" : ", ") + how; };
  const auto add = [&](const std::string &points, const std::string &how) {
    data += fmt::format("$points_{} << END\n{}END\n", number, points);
    plot(fmt::format("$points_{} using 1:2 {}", number++, how));
  };
  for (std::size_t i = 0; i < subjects.size(); ++i)
    for (const trade_cell &c : all) {
      if (c.family != family || subjects.at(i).predicate != c.by->name)
        continue;
      title = c.in_words;
      std::string proved;
      for (const trade_point &p : c.result.points) {
        const double x = 1e9 * p.seconds;
        for (const mark &m : marks)
          if (m.method == p.method.name)
            add(fmt::format("{:.6g} {:.6g}\n", x, height(c, p.wrong, i)),
                fmt::format("with points pointtype {} pointsize 1.5 linewidth 2 linecolor rgb '{}' notitle", m.shape,
                            subjects.at(i).colour));
        // The line goes through the plain rungs of the processor.
        if (!p.on_device && p.method.grid == 0 && p.wrong.proved && std::isfinite(*p.wrong.proved) &&
            *p.wrong.proved > 0)
          proved += fmt::format("{:.6g} {:.6g}\n", x, height(c, *p.wrong.proved));
      }
      plot(fmt::format("NaN with lines linewidth 4 linecolor rgb '{}' title '{}'", subjects.at(i).colour,
                       subjects.at(i).predicate));
      if (!proved.empty())
        add(proved, fmt::format("with lines dashtype 2 linewidth 1.5 linecolor rgb '{}' title '{}, proved'",
                                subjects.at(i).colour, subjects.at(i).predicate));
    }
  for (const mark &m : marks)
    plot(fmt::format("NaN with points pointtype {} pointsize 1.5 linewidth 2 linecolor rgb '#404040' title '{}'",
                     m.shape, m.method));
  return fmt::format("{}set title {}\nplot {}\n", data, gnuplot_string(title), plots.empty() ? "NaN notitle" : plots);
}

} // namespace

void draw_trade(const std::filesystem::path &to, const std::string &about, const std::vector<trade_cell> &all) {
  std::vector<std::string> families;
  for (const trade_cell &c : all)
    if (std::find(families.begin(), families.end(), c.family) == families.end())
      families.push_back(c.family);
  const bool on_device = std::any_of(all.begin(), all.end(), [](const trade_cell &c) {
    return std::any_of(c.result.points.begin(), c.result.points.end(),
                       [](const trade_point &p) { return p.on_device; });
  });
  constexpr std::size_t across = 2;
  const std::size_t rows = (families.size() + across - 1) / across;
  std::string script = fmt::format(
      "set encoding utf8\n"
      "set terminal pngcairo noenhanced size 1300,{} background '#fcfcfb' font 'Sans,10'\n"
      "set multiplot layout {},{} title {}\n"
      "set logscale xy\nset border 3\nset tics nomirror out\nset grid lt 1 lc rgb '#e4e7ea'\n"
      "set key outside right top vertical samplen 2 font 'Sans,8'\n"
      "set xlabel 'ns a pair'\nset ylabel 'farthest wrong answer / size'\nset xrange [{}:5000]\nset yrange [{}:{}]\n"
      "set ytics ('none wrong' {}, 'wrong by 0' {}, '1e-32' 1e-32, '1e-24' 1e-24, '1e-16' 1e-16, '1e-8' 1e-8, '1' 1)\n",
      60 + 340 * rows, rows, across, gnuplot_string(about), on_device ? 2e-3 : 1, never / apart, most, never * apart,
      by_nothing * apart);
  for (const std::string &family : families)
    script += panel(family, all);
  run_gnuplot(script + "unset multiplot\n", to);
}

} // namespace meetc::bench
