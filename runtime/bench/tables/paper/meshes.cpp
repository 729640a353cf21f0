// Bunny and Armadillo: how many triangles touch (section 4.1, figures 1 to 3), and how long one core takes with our
// predicate and with the classic ones (section 4.3, figure 6).
#include "meet/bench/tables/paper/paper.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace meetc::bench {

namespace {

// A row of the paper's table of collided triangles.
struct printed_row {
  const char *name;
  double armadillo;
  std::uint64_t bunny_hit, armadillo_hit;
};
constexpr std::array<printed_row, 6> printed{{{"1K-5K", 5e3, 187, 491},
                                              {"1K-20K", 20e3, 185, 996},
                                              {"1K-100K", 100e3, 194, 2215},
                                              {"1K-345K", 345e3, 195, 3968},
                                              {"1K-1000K", 1e6, 107, 5498},
                                              {"1K-5000K", 5e6, 191, 15063}}};

// The row of about this size; null where there is none.
const printed_row *printed_for(const paper_row &r) {
  for (const printed_row &row : printed)
    if (std::abs(std::log(static_cast<double>(r.b) / row.armadillo)) < std::log(1.5))
      return &row;
  return nullptr;
}

// A column of the printed table.
template <class Form, class Figure>
column<paper_row> of_paper(const char *key, const char *title, Form form, Figure figure) {
  return {key, title, [form, figure](const paper_row &r) {
            const printed_row *const p = printed_for(r);
            return p ? form(std::invoke(figure, *p)) : missing();
          }};
}

double per_root(std::uint64_t hits, double triangles) {
  return static_cast<double>(hits) / std::sqrt(triangles);
}

constexpr double scatter = 0.1;

// Adds the scalings, and returns what the table of counts notes of them.
std::vector<std::string> add_scalings(const paper_context &c, const std::vector<paper_row> &rows, paper_result &to) {
  std::vector<double> sizes, armadillo_hits, bunny_hits, printed_sizes, printed_hits;
  for (const paper_row &r : rows) {
    sizes.push_back(static_cast<double>(r.b));
    armadillo_hits.push_back(static_cast<double>(r.hit_b));
    bunny_hits.push_back(static_cast<double>(r.hit_a));
  }
  for (const printed_row &row : printed) {
    printed_sizes.push_back(row.armadillo);
    printed_hits.push_back(static_cast<double>(row.armadillo_hit));
  }
  const std::string bunny = c.bodies.bunny_name(), armadillo = c.bodies.armadillo_name();
  to.scalings = {{"armadillo_hit", fmt::format("{} triangles hit, over {} triangles", armadillo, armadillo),
                  fit_power(sizes, armadillo_hits, 0.5, scatter)},
                 {"bunny_hit", fmt::format("{} triangles hit, over {} triangles", bunny, armadillo),
                  fit_power(sizes, bunny_hits, 0, scatter)},
                 {"paper_armadillo_hit", "The paper's own rows of the Armadillo",
                  fit_power(printed_sizes, printed_hits, 0.5, scatter)}};
  std::vector<std::string> notes;
  for (const paper_scaling &scaling : to.scalings)
    notes.push_back(fmt::format("{}: {}.", scaling.words, in_words(scaling.fit)));
  notes.push_back(fmt::format("The curve in which two surfaces cross meets c sqrt(n) of n triangles of one of them. A "
                              "tolerance is what counts that are off by up to {:.0f} % can do to the exponent.",
                              100 * scatter));
  notes.push_back(
      fmt::format("The paper does not give its pose, so its counts cannot be reproduced. Here the Armadillo "
                  "is placed by `{}`.",
                  c.bodies.pose_options()));
  return notes;
}

// The tests of a row, after certified and fp32.
constexpr std::size_t certified = 0, conformal = 1, moller = 2, moller_epsilon = 3, guigue_devillers = 4;

column<paper_row> ratio_to_moller(const char *key, const char *title, std::size_t test) {
  return {key, title, [test](const paper_row &r) { return of_ratio(r.over(test, moller)); }};
}
column<paper_row> wrong_answers(const char *key, const char *title, std::size_t test) {
  return {key, title, [test](const paper_row &r) { return of_count(r.wrong[test].wrong()); }};
}

void add_tables(const paper_context &c, const std::vector<paper_row> &rows, paper_result &to) {
  const std::string bunny = c.bodies.bunny_name(), armadillo = c.bodies.armadillo_name();
  const column<paper_row> size{"armadillo", armadillo + "|triangles", of_count, &paper_row::b};
  to.tables.push_back(table_of<paper_row>(
      "meshes", fmt::format("{} and {} (section 4.1, figure 2): triangles that touch", bunny, armadillo),
      {size,
       {"pairs", "pairs|touch", of_count, &paper_row::pairs},
       {"bunny_hit", bunny + "|hit", of_count, &paper_row::hit_a},
       {"armadillo_hit", armadillo + "|hit", of_count, &paper_row::hit_b},
       {"per_root", "hit / root|of triangles", of_ratio,
        [](const paper_row &r) { return per_root(r.hit_b, static_cast<double>(r.b)); }},
       of_paper("paper_row", "the paper's|row", of_words, &printed_row::name),
       of_paper("paper_bunny_hit", "Bunny|hit", of_count, &printed_row::bunny_hit),
       of_paper("paper_armadillo_hit", "Armadillo|hit", of_count, &printed_row::armadillo_hit),
       of_paper("paper_per_root", "hit / root|of triangles", of_ratio,
                [](const printed_row &p) { return per_root(p.armadillo_hit, p.armadillo); })},
      rows, add_scalings(c, rows, to)));
  std::vector<std::string> notes{
      "one core: the paper's way, brute force over every pair, by the conformal predicate in fp32; its time is a "
      "multiple of the first row's.",
      "search: meet's way on one core, with a hierarchy of boxes, certified, both sets made ready."};
  for (std::string &claim : claim_of(c, rows))
    notes.push_back(std::move(claim));
  to.tables.push_back(table_of<paper_row>(
      "mesh_times", fmt::format("{} and {} (figure 3): times", bunny, armadillo),
      with_device(
          {size,
           core_column(rows),
           {"certified_over_fp32", "certified|/ fp32",
            [](const paper_row &r) { return of_ratio(r.over(certified, conformal)); }},
           {"blind_over_search", "one core|/ search", [](const paper_row &r) { return of_ratio(r.core() / r.search); }},
           {"search_certified_over_fp32", "in the search,|certified / fp32", of_ratio,
            &paper_row::search_certified_over_fp32}}),
      rows, std::move(notes)));
  to.tables.push_back(table_of<paper_row>(
      "moller", "R3 on the CPU and R(4,1) on the CPU (section 4.3, figure 6): brute force over every pair, one core",
      {size,
       ratio_to_moller("conformal_over_moller", "conformal|/ Möller", conformal),
       ratio_to_moller("certified_over_moller", "certified|/ Möller", certified),
       ratio_to_moller("moller_epsilon_over_moller", "eps 1e-6|/ Möller", moller_epsilon),
       ratio_to_moller("guigue_devillers_over_moller", "Guigue-Dev.|/ Möller", guigue_devillers),
       {"pairs", "pairs|compared", of_count, &paper_row::compared},
       {"hits", "of these|touch", [](const paper_row &r) { return of_count(r.wrong[certified].found); }},
       wrong_answers("conformal_wrong", "conformal|fp32 wrong", conformal),
       wrong_answers("moller_wrong", "Möller|wrong", moller),
       wrong_answers("moller_epsilon_wrong", "eps 1e-6|wrong", moller_epsilon),
       wrong_answers("guigue_devillers_wrong", "Guigue-Dev.|wrong", guigue_devillers)},
      rows,
      {"The paper: Möller's test is 4 times as fast as the conformal model. Here: ratios of times, all in float32. "
       "Möller: with epsilon 0; eps 1e-6: with the epsilon of his program, which does not know the scene's unit.",
       "wrong: answers that differ from the certified ones."}));
}

void add_charts(const paper_context &c, const std::vector<paper_row> &rows, paper_result &to) {
  const std::string armadillo = c.bodies.armadillo_name(),
                    both = fmt::format("{} - {}", c.bodies.bunny_name(), armadillo);
  to.figures.push_back(figure_of(c, 3,
                                 {both + " intersection times", armadillo + " triangles",
                                  "time / one core's in the first row", curves_of(c, rows)}));
  const auto of_test = [&rows](std::size_t test) {
    return points_of(rows, rows.front().tests[moller], [test](const paper_row &r) { return r.tests[test]; });
  };
  to.figures.push_back(figure_of(c, 6,
                                 {"Fast CPU and conformal CPU triangle intersections, one core",
                                  armadillo + " triangles",
                                  "time / Moeller's in the first row",
                                  {{"Moeller, CPU", curve_colours::red, of_test(moller)},
                                   {"conformal, CPU", curve_colours::cpu, of_test(conformal)},
                                   {"conformal, certified, CPU", curve_colours::search, of_test(certified)}}}));
}

} // namespace

std::size_t mesh_rows(const paper_context &c) {
  return c.bodies.sizes();
}

void add_meshes(const paper_context &c, paper_result &to) {
  const io::element_set &bunny = c.bodies.bunny();
  const std::vector<pair_test> tests =
      conformal_and(c, bunny, bunny, {classic::moller_0, classic::moller, classic::guigue_devillers});
  std::vector<paper_row> rows;
  c.bodies.each_armadillo([&](const io::element_set &armadillo, const std::string &) {
    app::answers found;
    rows.push_back(measure_row(c, bunny, armadillo, tests, found));
    if (rows.size() == std::min<std::size_t>(2, mesh_rows(c))) // the triangles of such a mesh are large enough to see
      to.figures.push_back(
          figure_of(c, 2, fmt::format("{} - {} intersection", c.bodies.bunny_name(), c.bodies.armadillo_name()),
                    {{bunny, found.a.hit, c.bodies.bunny_name(), picture::palette::calm[0], picture::palette::yellow},
                     {armadillo, found.b.hit, c.bodies.armadillo_name(), picture::palette::calm[1],
                      picture::palette::vermilion}}));
    c.advance();
  });
  add_tables(c, rows, to);
  add_charts(c, rows, to);
}

} // namespace meetc::bench
