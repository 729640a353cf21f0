// Line segments against the Bunny with a growing number of triangles: the table of times in section 4.2, and a large
// triangle through the Bunny, figure 1.
#include "meet/bench/tables/paper/paper.hpp"

#include "meet/app/input/made_sets.hpp"
#include "meet/bench/scenes/scene_sets.hpp"

#include <fmt/format.h>

#include <utility>

namespace meetc::bench {

namespace {

// The last row in the paper, in milliseconds.
constexpr double printed_cpu = 30034.4, printed_gpu = 715.872;
constexpr std::size_t many = 1000;

// Maps rows of points in [-1, 1]^3 to the box around a mesh.
std::vector<float> placed(const io::element_set &mesh, std::vector<float> rows) {
  const mesh_extent e = extent_of(mesh);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double low = e.lo[i % 3], high = e.hi[i % 3];
    rows[i] = static_cast<float>((low + high) / 2 + (high - low) / 2 * static_cast<double>(rows[i]));
  }
  return rows;
}

paper_figure large_triangle(const paper_context &c) {
  const io::element_set &bunny = c.bodies.fine_bunny();
  bodies::mesh m;
  m.xyz = placed(bunny, {-1.9F, -0.3F, 1.1F, 1.9F, 0.1F, 1.3F, 0.1F, 0.5F, -2.2F});
  m.index = {0, 1, 2};
  io::element_set triangle = app::of_mesh(c.all, std::move(m));
  const app::answers found = search_pairs(c, triangle, bunny, false);
  return figure_of(c, 1, fmt::format("Triangle - {} intersection", c.bodies.bunny_name()),
                   {{std::move(triangle), {}, "triangle", picture::palette::calm[1], picture::palette::calm[1]},
                    {bunny, found.b.hit, c.bodies.bunny_name(), picture::palette::calm[0], picture::palette::yellow}});
}

} // namespace

std::size_t segment_rows(const paper_context &c) {
  return c.quick ? 4 : 7;
}

void add_segments(const paper_context &c, paper_result &to) {
  constexpr std::size_t certified = 0, conformal = 1, moller_trumbore = 2;
  const io::element_set &whole = c.bodies.bunny();
  const io::element_set one = app::of_rows(c.all, "segment", placed(whole, {-1.1F, -1.2F, -0.9F, 1.1F, 1.2F, 0.9F}));
  const io::element_set cloud = app::of_rows(c.all, "segment", placed(whole, bodies::segment_cloud(many, 5, 0.5)));
  const std::vector<pair_test> tests = conformal_and(c, one, whole, {classic::moller_trumbore});
  std::vector<paper_row> rows;
  for (std::size_t times = 0; times < segment_rows(c); ++times) {
    const io::element_set bunny = c.bodies.finer_bunny(static_cast<int>(times));
    app::answers found;
    for (const io::element_set *const segments : {&one, &cloud})
      rows.push_back(measure_row(c, *segments, bunny, tests, found));
    c.advance();
  }
  std::vector<std::string> notes{
      fmt::format("The paper's row: one segment, 4000K triangles, CPU {:.0f} ms, GPU {:.0f} ms: one core / GPU = "
                  "{:.1f}, where its text says three orders of magnitude.",
                  printed_cpu, printed_gpu, printed_cpu / printed_gpu),
      "Each row cuts every triangle of the one before into four: the same surface, so hits stay but where a "
      "segment meets a new edge or a middle is rounded.",
      "one core / search: the search makes both sets ready first, which one segment does not repay."};
  for (std::string &claim : claim_of(c, rows))
    notes.push_back(std::move(claim));
  to.tables.push_back(table_of<paper_row>(
      "segments",
      fmt::format("Line segments and the {} at increasing triangle counts (section 4.2)", c.bodies.bunny_name()),
      with_device({{"triangles", c.bodies.bunny_name() + "|triangles", of_count, &paper_row::b},
                   {"segments", "segments", of_count, &paper_row::a},
                   {"pairs", "pairs|touch", of_count, &paper_row::pairs},
                   core_column(rows),
                   {"conformal_over_moller_trumbore", "conformal|/ Möller-Tr.",
                    [](const paper_row &r) { return of_ratio(r.over(conformal, moller_trumbore)); }},
                   {"certified_over_moller_trumbore", "certified|/ Möller-Tr.",
                    [](const paper_row &r) { return of_ratio(r.over(certified, moller_trumbore)); }},
                   {"blind_over_search", "one core|/ search",
                    [](const paper_row &r) { return of_ratio(r.core() / r.search); }}}),
      rows, std::move(notes)));
  to.figures.push_back(large_triangle(c));
}

} // namespace meetc::bench
