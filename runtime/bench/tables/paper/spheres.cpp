// Random spheres against each other: section 4.2, figures 4 and 5.
#include "meet/bench/tables/paper/paper.hpp"

#include "meet/app/input/made_sets.hpp"

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

paper_row measure_cloud(const paper_context &c, std::size_t n, paper_result &to) {
  const double r = radius_for(n);
  const io::element_set set = app::of_rows(c.all, "sphere", bodies::sphere_cloud(n, n, r / 2, 1.5 * r));
  app::answers found;
  paper_row row = measure_row(c, set, set, conformal_and(c, set, set, {classic::balls}), found);
  std::vector<std::uint8_t> touched(n, 0);
  row.pairs = row.hit_a = 0;
  for (const index_pair &p : found.list)
    if (p.a != p.b) { // each such pair occurs in both orders
      row.pairs += p.a < p.b;
      row.hit_a += touched[p.a] == 0;
      touched[p.a] = 1;
    }
  row.expected = static_cast<std::uint64_t>(std::llround(expected_pairs(n)));
  if (n == 500)
    to.figures.push_back(figure_of(
        c, 4, "Spheres - spheres intersection",
        std::vector<painted_set>{{set, touched, "spheres", picture::palette::calm[1], picture::palette::yellow}}));
  return row;
}

} // namespace

std::size_t sphere_rows(const paper_context &c) {
  return counts_of(c.quick).size();
}

void add_spheres(const paper_context &c, paper_result &to) {
  constexpr std::size_t certified = 0, conformal = 1, euclid = 2;
  std::vector<paper_row> rows;
  for (const std::size_t n : counts_of(c.quick)) {
    rows.push_back(measure_cloud(c, n, to));
    c.advance();
  }
  std::vector<std::string> notes{
      "The paper does not give its radii. Here they shrink as n^(-1/3), so that a sphere touches half a neighbour on "
      "average at every n; expected: what a cloud of random solid balls in a cube gives.",
      "one core: every ordered pair, by brute force and the conformal predicate in fp32; Euclid: d^2 <= (r1 + r2)^2 in "
      "float."};
  for (std::string &claim : claim_of(c, rows))
    notes.push_back(std::move(claim));
  to.tables.push_back(table_of<paper_row>(
      "spheres", "Random spheres against each other (section 4.2, figures 4 and 5)",
      with_device(
          {{"spheres", "spheres", of_count, &paper_row::b},
           {"pairs", "pairs|touch", of_count, &paper_row::pairs},
           {"expected", "expected|on average", of_count, &paper_row::expected},
           {"touched", "spheres|touching", of_count, &paper_row::hit_a},
           core_column(rows),
           {"conformal_over_euclid", "conformal|/ Euclid",
            [](const paper_row &r) { return of_ratio(r.over(conformal, euclid)); }},
           {"certified_over_euclid", "certified|/ Euclid",
            [](const paper_row &r) { return of_ratio(r.over(certified, euclid)); }},
           {"blind_over_search", "one core|/ search", [](const paper_row &r) { return of_ratio(r.core() / r.search); }},
           {"search_certified_over_fp32", "in the search,|certified / fp32", of_ratio,
            &paper_row::search_certified_over_fp32}}),
      rows, std::move(notes)));
  to.figures.push_back(figure_of(
      c, 5,
      {"Spheres - spheres intersection times", "spheres", "time / one core's in the first row", curves_of(c, rows)}));
}

} // namespace meetc::bench
