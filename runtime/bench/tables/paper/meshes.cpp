// Bunny and Armadillo: how many triangles touch (section 4.1, figures 1 to 3), and how long one core takes with our
// predicate and with the classic ones (section 4.3, figure 6).
#include "bench/tables/paper/parts.hpp"

#include "app/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
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
const printed_row *printed_for(std::size_t triangles) {
  for (const printed_row &row : printed)
    if (std::abs(std::log(static_cast<double>(triangles) / row.armadillo)) < std::log(1.5))
      return &row;
  return nullptr;
}

constexpr double scatter = 0.1;

table counts_table(const paper_context &c) {
  table t;
  t.name = "meshes";
  t.title = fmt::format("{} and {} (section 4.1, figure 2): triangles that touch", c.bodies.bunny_name(),
                        c.bodies.armadillo_name());
  const std::string bunny = c.bodies.bunny_name(), armadillo = c.bodies.armadillo_name();
  t.columns = {{"armadillo", armadillo + "|triangles"},
               {"pairs", "pairs|touch"},
               {"bunny_hit", bunny + "|hit"},
               {"armadillo_hit", armadillo + "|hit"},
               {"per_root", "hit / root|of triangles"},
               {"paper_row", "the paper's|row"},
               {"paper_bunny_hit", "Bunny|hit"},
               {"paper_armadillo_hit", "Armadillo|hit"},
               {"paper_per_root", "hit / root|of triangles"}};
  return t;
}

table times_table(const paper_context &c) {
  table t;
  t.name = "mesh_times";
  t.title = fmt::format("{} and {} (figure 3): times", c.bodies.bunny_name(), c.bodies.armadillo_name());
  t.columns = {{"armadillo", c.bodies.armadillo_name() + "|triangles"},
               {"core", "one core,|x first row"},
               {"certified_over_fp32", "certified|/ fp32"},
               {"blind_over_search", "one core|/ search"},
               {"search_certified_over_fp32", "in the search,|certified / fp32"}};
  for (const column &k : device_columns())
    t.columns.push_back(k);
  t.notes = {
      "one core: the paper's way, brute force over every pair, by the conformal predicate in fp32; its time is a "
      "multiple of the first row's.",
      "search: meet's way on one core, with a hierarchy of boxes, certified, both sets made ready."};
  return t;
}

table baselines_table(const paper_context &c) {
  table t;
  t.name = "moller";
  t.title = "R3 on the CPU and R(4,1) on the CPU (section 4.3, figure 6): brute force over every pair, one core";
  t.columns = {{"armadillo", c.bodies.armadillo_name() + "|triangles"},
               {"conformal_over_moller", "conformal|/ Möller"},
               {"certified_over_moller", "certified|/ Möller"},
               {"moller_epsilon_over_moller", "eps 1e-6|/ Möller"},
               {"guigue_devillers_over_moller", "Guigue-Dev.|/ Möller"},
               {"pairs", "pairs|compared"},
               {"hits", "of these|touch"},
               {"conformal_wrong", "conformal|fp32 wrong"},
               {"moller_wrong", "Möller|wrong"},
               {"moller_epsilon_wrong", "eps 1e-6|wrong"},
               {"guigue_devillers_wrong", "Guigue-Dev.|wrong"}};
  t.notes = {"The paper: Möller's test is 4 times as fast as the conformal model. Here: ratios of times, all "
             "in float32. "
             "Möller: with epsilon 0; eps 1e-6: with the epsilon of his program, which does not know the "
             "scene's unit.",
             "wrong: answers that differ from the certified ones."};
  return t;
}

cell wrong(const brute_force_time &t) {
  return of_count(t.wrong_yes + t.wrong_no);
}

void add_scalings(const paper_context &c, const std::vector<double> &sizes, const std::vector<double> &armadillo_hits,
                  const std::vector<double> &bunny_hits, table &counts, paper_result &to) {
  std::vector<double> printed_sizes, printed_hits;
  for (const printed_row &row : printed) {
    printed_sizes.push_back(row.armadillo);
    printed_hits.push_back(static_cast<double>(row.armadillo_hit));
  }
  const std::string armadillo = c.bodies.armadillo_name();
  to.scalings.push_back({"armadillo_hit", fmt::format("{} triangles hit, over {} triangles", armadillo, armadillo),
                         fit_power(sizes, armadillo_hits, 0.5, scatter)});
  to.scalings.push_back({"bunny_hit",
                         fmt::format("{} triangles hit, over {} triangles", c.bodies.bunny_name(), armadillo),
                         fit_power(sizes, bunny_hits, 0, scatter)});
  to.scalings.push_back({"paper_armadillo_hit", "The paper's own rows of the Armadillo",
                         fit_power(printed_sizes, printed_hits, 0.5, scatter)});
  for (const paper_scaling &scaling : to.scalings)
    counts.notes.push_back(fmt::format("{}: {}.", scaling.words, in_words(scaling.fit)));
  counts.notes.push_back(fmt::format("The curve in which two surfaces cross meets c sqrt(n) of n triangles "
                                     "of one of them. A tolerance is what counts "
                                     "that are off by up to {:.0f} % can do to the exponent.",
                                     100 * scatter));
  counts.notes.push_back(fmt::format("The paper does not give its pose, so its counts cannot be reproduced. "
                                     "Here the Armadillo is placed by "
                                     "`{}`.",
                                     c.bodies.pose_options()));
}

} // namespace

std::size_t mesh_rows(const paper_context &c) {
  return c.bodies.sizes();
}

void add_meshes(const paper_context &c, paper_result &to) {
  table counts = counts_table(c), times = times_table(c), baselines = baselines_table(c);
  const io::element_set &bunny = c.bodies.bunny();
  const app::choice by = app::choose(c.all, *bunny.kind, *bunny.kind, {}, {});
  const std::vector<decide_function> tests{decide_by(by, rung::certified), decide_by(by, rung::fp32), classic::moller_0,
                                           classic::moller, classic::guigue_devillers};
  std::vector<double> sizes, armadillo_hits, bunny_hits, over_gpu;
  curve core{"one core, every pair, conformal fp32", curve_colours::cpu, {}},
      searched{"one core, meet's search, certified", curve_colours::search, {}},
      device{"GPU, every pair, certified, with transfers", curve_colours::gpu, {}},
      moller{"Moeller, CPU", curve_colours::red, {}}, conformal{"conformal, CPU", curve_colours::cpu, {}},
      certified{"conformal, certified, CPU", curve_colours::search, {}};
  double first_core = 0, first_moller = 0;
  std::optional<paper_scene> scene;
  c.bodies.each_armadillo([&](const io::element_set &armadillo, const std::string &) {
    const search s = search_pairs(c, bunny, armadillo, false);
    const brute_force_times brute = time_brute_force(c.by, tests, *by.predicate, bunny, armadillo, c.budget, c.runs);
    const double n = static_cast<double>(armadillo.elements), root = std::sqrt(n);
    sizes.push_back(n);
    armadillo_hits.push_back(static_cast<double>(s.found.b.touched));
    bunny_hits.push_back(static_cast<double>(s.found.a.touched));

    const printed_row *paper = printed_for(armadillo.elements);
    counts.rows.push_back({of_count(armadillo.elements), of_count(s.found.pairs), of_count(s.found.a.touched),
                           of_count(s.found.b.touched), of_ratio(static_cast<double>(s.found.b.touched) / root)});
    if (paper)
      counts.rows.back().insert(counts.rows.back().end(),
                                {of_words(paper->name), of_count(paper->bunny_hit), of_count(paper->armadillo_hit),
                                 of_ratio(static_cast<double>(paper->armadillo_hit) / std::sqrt(paper->armadillo))});
    else
      counts.rows.back().insert(counts.rows.back().end(), 4, missing("-"));

    const double certified_time = brute.of[0].time, core_time = brute.of[1].time, moller_time = brute.of[2].time;
    if (sizes.size() == 1) {
      first_core = core_time;
      first_moller = moller_time;
    }
    device_cells gpu = ask_device(c, bunny, armadillo, s.found.pairs, core_time);
    over_gpu.push_back(gpu.core_over_gpu);
    times.rows.push_back({of_count(armadillo.elements), of_ratio(core_time / first_core),
                          of_ratio(certified_time / core_time), of_ratio(core_time / s.time),
                          of_ratio(s.certified_over_fp32)});
    times.rows.back().insert(times.rows.back().end(), gpu.cells.begin(), gpu.cells.end());
    baselines.rows.push_back(
        {of_count(armadillo.elements), of_ratio(core_time / moller_time), of_ratio(certified_time / moller_time),
         of_ratio(brute.of[3].time / moller_time), of_ratio(brute.of[4].time / moller_time), of_count(brute.pairs),
         of_count(brute.of[0].yes), wrong(brute.of[1]), wrong(brute.of[2]), wrong(brute.of[3]), wrong(brute.of[4])});
    core.points.emplace_back(n, core_time / first_core);
    searched.points.emplace_back(n, s.time / first_core);
    device.points.emplace_back(n, gpu.time / first_core);
    moller.points.emplace_back(n, moller_time / first_moller);
    conformal.points.emplace_back(n, core_time / first_moller);
    certified.points.emplace_back(n, certified_time / first_moller);
    if (sizes.size() <= 2) // the triangles of such a mesh are large enough to see
      scene = paper_scene{bunny,
                          armadillo,
                          s.found.a.hit,
                          s.found.b.hit,
                          c.bodies.bunny_name(),
                          c.bodies.armadillo_name(),
                          picture::palette::red,
                          picture::palette::blue,
                          picture::palette::yellow,
                          picture::palette::pink};
    c.advance();
  });
  add_scalings(c, sizes, armadillo_hits, bunny_hits, counts, to);
  add_claim(c, over_gpu, times);
  to.tables.push_back(std::move(counts));
  to.tables.push_back(std::move(times));
  to.tables.push_back(std::move(baselines));
  const std::string both = fmt::format("{} - {}", c.bodies.bunny_name(), c.bodies.armadillo_name());
  to.figures.push_back({2, both + " intersection", std::move(scene), {}});
  chart plot{both + " intersection times",
             c.bodies.armadillo_name() + " triangles",
             "time / one core's in the first row",
             {core, searched}};
  if (c.device)
    plot.curves.push_back(device);
  to.figures.push_back({3, plot.title, {}, plot});
  chart fast{"Fast CPU and conformal CPU triangle intersections, one core",
             c.bodies.armadillo_name() + " triangles",
             "time / Moeller's in the first row",
             {moller, conformal, certified}};
  to.figures.push_back({6, fast.title, {}, fast});
}

} // namespace meetc::bench
