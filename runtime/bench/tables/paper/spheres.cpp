// Random spheres against each other: section 4.2, figures 4 and 5.
#include "bench/tables/paper/parts.hpp"

#include "app/made_sets.hpp"
#include "app/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace meetc::bench {

namespace {

// The paper does not give its radii. Here they shrink as n^(-1/3), uniform from half to one and a half times r. At
// every n a sphere then touches `neighbours` others on average, if the walls of the cube are ignored: neighbours = n
// E[4/3 pi s^3] / 8, where s is the sum of two radii and E[s^3] = 9 r^3.
constexpr double neighbours = 0.5, pi = 3.14159265358979323846;

double radius_for(std::size_t n) {
  return std::cbrt(neighbours / (1.5 * pi * static_cast<double>(n)));
}

// The probability that two uniform points in a unit cube are within s <= 1 of each other.
double near_in_cube(double s) {
  return s * s * s * (pi * 4 / 3 - s * (pi * 3 / 2 - s * (8.0 / 5 - s / 6)));
}

// The mean number of touching pairs over all clouds of n spheres in a cube of edge 2.
double expected_pairs(std::size_t n) {
  constexpr int steps = 64;
  const double r = radius_for(n), count = static_cast<double>(n);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      sum += near_in_cube(r * (1 + (i + j + 1.0) / steps) / 2);
  return count * (count - 1) / 2 * sum / (steps * steps);
}

std::vector<std::size_t> counts_of(bool quick) {
  if (quick)
    return {500, 1000, 2500, 5000, 10'000};
  return {500, 1000, 2500, 5000, 10'000, 100'000, 1'000'000};
}

} // namespace

std::size_t sphere_rows(const paper_context &c) {
  return counts_of(c.quick).size();
}

void add_spheres(const paper_context &c, paper_result &to) {
  table t;
  t.name = "spheres";
  t.title = "Random spheres against each other (section 4.2, figures 4 and 5)";
  t.columns = {{"spheres", "spheres"},
               {"pairs", "pairs|touch"},
               {"expected", "expected|on average"},
               {"touched", "spheres|touching"},
               {"core", "one core,|x first row"},
               {"conformal_over_euclid", "conformal|/ Euclid"},
               {"certified_over_euclid", "certified|/ Euclid"},
               {"blind_over_search", "one core|/ search"},
               {"search_certified_over_fp32", "in the search,|certified / fp32"}};
  for (const column &k : device_columns())
    t.columns.push_back(k);
  t.notes = {
      "The paper does not give its radii. Here they shrink as n^(-1/3), so that a sphere touches half a "
      "neighbour on average at every n; expected: what a cloud of random solid balls in a cube gives.",
      "one core: every ordered pair, by brute force and the conformal predicate in fp32; Euclid: d^2 <= (r1 + r2)^2 "
      "in "
      "float."};
  curve core{"one core, every pair, conformal fp32", curve_colours::cpu, {}},
      searched{"one core, meet's search, certified", curve_colours::search, {}},
      device{"GPU, every pair, certified, with transfers", curve_colours::gpu, {}};
  double first = 0;
  std::vector<double> over_gpu;
  std::optional<paper_scene> scene;
  for (const std::size_t n : counts_of(c.quick)) {
    const double r = radius_for(n);
    const io::element_set set = app::of_rows(c.all, "sphere", bodies::sphere_cloud(n, n, r / 2, 1.5 * r));
    const search s = search_pairs(c, set, set, true);
    std::vector<std::uint8_t> touched(n, 0);
    std::uint64_t pairs = 0, touching = 0;
    for (const index_pair &p : s.found.list)
      if (p.a != p.b) { // each such pair occurs in both orders
        pairs += p.a < p.b;
        touching += touched[p.a] == 0;
        touched[p.a] = 1;
      }
    const app::choice by = app::choose(c.all, *set.kind, *set.kind, {}, {});
    const std::vector<decide_function> tests{decide_by(by, rung::certified), decide_by(by, rung::fp32), classic::balls};
    const brute_force_times brute = time_brute_force(c.by, tests, *by.predicate, set, set, c.budget, c.runs);
    const double core_time = brute.of[1].time, euclid = brute.of[2].time;
    if (first == 0)
      first = core_time;
    device_cells gpu = ask_device(c, set, set, s.found.pairs, core_time);
    t.rows.push_back({of_count(n), of_count(pairs),
                      of_count(static_cast<std::uint64_t>(std::llround(expected_pairs(n)))), of_count(touching),
                      of_ratio(core_time / first), of_ratio(core_time / euclid), of_ratio(brute.of[0].time / euclid),
                      of_ratio(core_time / s.time), of_ratio(s.certified_over_fp32)});
    t.rows.back().insert(t.rows.back().end(), gpu.cells.begin(), gpu.cells.end());
    const auto x = static_cast<double>(n);
    core.points.emplace_back(x, core_time / first);
    searched.points.emplace_back(x, s.time / first);
    device.points.emplace_back(x, gpu.time / first);
    if (n == 500)
      scene =
          paper_scene{set, {}, touched, {}, "spheres", "", picture::palette::blue, {}, picture::palette::orange, {}};
    c.advance();
  }
  add_claim(c, over_gpu, t);
  to.tables.push_back(std::move(t));
  to.figures.push_back({4, "Spheres - spheres intersection", std::move(scene), {}});
  chart plot{"Spheres - spheres intersection times", "spheres", "time / one core's in the first row", {core, searched}};
  if (c.device)
    plot.curves.push_back(device);
  to.figures.push_back({5, plot.title, {}, plot});
}

} // namespace meetc::bench
