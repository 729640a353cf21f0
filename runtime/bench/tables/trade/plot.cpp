// The picture of `meet trade`: speed across, error upwards.
#include "meet/bench/tables/trade/tables.hpp"
#include "meet/picture/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace meetc::bench {

namespace {

// The predicates in the picture, each in the palette's colour of its place; all are in the table.
constexpr std::array<std::string_view, 4> subjects{"triangle_triangle", "segment_triangle", "sphere_sphere",
                                                   "ball_ball"};
static_assert(subjects.size() <= picture::palette::series.size());

// The methods, by gnuplot's shapes.
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
  return w.differs.wrong() == 0 ? never * line : w.farthest == 0 ? by_nothing * line : height(c, w.farthest);
}

template <class Test> bool any_point(const std::vector<trade_cell> &all, const Test &test) {
  return std::any_of(all.begin(), all.end(), [&test](const trade_cell &c) {
    return std::any_of(c.result.points.begin(), c.result.points.end(), test);
  });
}

// Adds the points of one predicate on one family. The line of what is proved goes through the plain rungs of the processor.
void add_points(const trade_cell &c, std::size_t subject, std::string &marks, std::string &proved) {
  const picture::colour ink = picture::palette::series.at(subject);
  const int colour = ink.r << 16 | ink.g << 8 | ink.b;
  for (const trade_point &p : c.result.points) {
    const double x = 1e9 * p.seconds;
    for (const mark &m : all_marks)
      if (m.method == p.method.name)
        marks += fmt::format("{:.6g} {:.6g} {} {}\n", x, height(c, p.wrong, subject), m.shape, colour);
    const std::optional<double> &bound = p.wrong.proved;
    if (!p.on_device && p.method.grid == 0 && bound && std::isfinite(*bound) && *bound > 0)
      proved += fmt::format("{:.6g} {:.6g} {}\n", x, height(c, *bound), colour);
  }
  proved += proved.empty() || proved.ends_with("\n\n") ? "" : "\n"; // the end of the line
}

} // namespace

plot plot_of_trade(const std::string &about, const std::vector<trade_cell> &all) {
  std::vector<std::string> titles, marks, proved, names, colours, labels, shapes;
  for (const std::string &family : families_of(all)) {
    titles.emplace_back(), marks.emplace_back(), proved.emplace_back();
    for (std::size_t i = 0; i < subjects.size(); ++i)
      for (const trade_cell &c : all)
        if (c.family == family && subjects.at(i) == c.by->name) {
          titles.back() = c.in_words;
          add_points(c, i, marks.back(), proved.back());
        }
    if (proved.back().ends_with("\n\n"))
      proved.back().pop_back(); // two empty lines would end the section
  }
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    names.emplace_back(subjects.at(i));
    colours.push_back(picture::hexadecimal(picture::palette::series.at(i)));
  }
  for (const mark &m : all_marks)
    if (any_point(all, [&m](const trade_point &p) { return p.method.name == m.method; })) {
      labels.emplace_back(m.method);
      shapes.push_back(fmt::format("{}", m.shape));
    }
  const bool on_device = any_point(all, [](const trade_point &p) { return p.on_device; });
  plot out("trade");
  out.set("about", about).set("least_ns", on_device ? 2e-3 : 1);
  out.set("panels", static_cast<double>(titles.size())).list("titles", titles);
  out.set("subjects", static_cast<double>(names.size())).list("names", names).list("colours", colours);
  out.set("methods", static_cast<double>(labels.size())).list("labels", labels).list("shapes", shapes);
  out.set("never", never).set("nothing", by_nothing).set("apart", apart).set("low", never / apart).set("high", most);
  out.data("marks", marks).data("proved", proved);
  return out;
}

} // namespace meetc::bench
