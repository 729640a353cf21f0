// Line segments against the Bunny with a growing number of triangles: the table of times in section 4.2, and a large
// triangle through the Bunny, figure 1.
#include "bench/tables/paper/parts.hpp"

#include "app/made_sets.hpp"
#include "app/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace meetc::bench {

namespace {

// The last row in the paper, in milliseconds.
constexpr double printed_cpu = 30034.4, printed_gpu = 715.872;
constexpr std::size_t many = 1000;
constexpr picture::colour triangle_green{112, 184, 118};

struct frame {
  std::array<double, 3> middle{}, half{};
  // The coordinate of a point that is given in halves of the box, from its centre.
  float at(std::size_t k, double v) const { return static_cast<float>(middle[k] + half[k] * v); }
};

frame frame_of(const io::element_set &mesh) {
  frame f;
  for (std::size_t k = 0; k < 3; ++k) {
    float low = INFINITY, high = -INFINITY;
    for (std::size_t i = k; i < mesh.data.size(); i += 3) {
      low = std::min(low, mesh.data[i]);
      high = std::max(high, mesh.data[i]);
    }
    f.middle[k] = (static_cast<double>(low) + high) / 2;
    f.half[k] = (static_cast<double>(high) - low) / 2;
  }
  return f;
}

// Maps rows of points in [-1, 1]^3 to the box.
std::vector<float> placed(const frame &f, std::vector<float> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = f.at(i % 3, static_cast<double>(rows[i]));
  return rows;
}

paper_scene large_triangle(const paper_context &c) {
  const io::element_set &bunny = c.bodies.fine_bunny();
  const frame f = frame_of(bunny);
  bodies::mesh m;
  m.xyz = placed(f, {-1.9F, -0.3F, 1.1F, 1.9F, 0.1F, 1.3F, 0.1F, 0.5F, -2.2F});
  m.index = {0, 1, 2};
  io::element_set triangle = app::of_mesh(c.all, std::move(m));
  const search s = search_pairs(c, triangle, bunny, false);
  return {std::move(triangle),
          bunny,
          {},
          s.found.b.hit,
          "triangle",
          c.bodies.bunny_name(),
          triangle_green,
          picture::palette::red,
          triangle_green,
          picture::palette::yellow};
}

} // namespace

std::size_t segment_rows(const paper_context &c) {
  return c.quick ? 4 : 7;
}

void add_segments(const paper_context &c, paper_result &to) {
  table t;
  t.name = "segments";
  t.title = fmt::format("Line segments and the {} at increasing triangle counts (section 4.2)", c.bodies.bunny_name());
  t.columns = {{"triangles", c.bodies.bunny_name() + "|triangles"},
               {"segments", "segments"},
               {"pairs", "pairs|touch"},
               {"core", "one core,|x first row"},
               {"conformal_over_moller_trumbore", "conformal|/ Möller-Tr."},
               {"certified_over_moller_trumbore", "certified|/ Möller-Tr."},
               {"blind_over_search", "one core|/ search"}};
  for (const column &k : device_columns())
    t.columns.push_back(k);
  t.notes = {
      fmt::format("The paper's row: one segment, 4000K triangles, CPU {:.0f} ms, GPU {:.0f} ms: one core / GPU = "
                  "{:.1f}, where its text says three orders of magnitude.",
                  printed_cpu, printed_gpu, printed_cpu / printed_gpu),
      "Each row cuts every triangle of the one before into four: the same surface, so hits stay but where a "
      "segment meets a new edge or a middle is rounded.",
      "one core / search: the search makes both sets ready first, which one segment does not repay."};
  const frame f = frame_of(c.bodies.bunny());
  const io::element_set one = app::of_rows(c.all, "segment", placed(f, {-1.1F, -1.2F, -0.9F, 1.1F, 1.2F, 0.9F}));
  const io::element_set cloud = app::of_rows(c.all, "segment", placed(f, bodies::segment_cloud(many, 5, 0.5)));
  const app::choice by = app::choose(c.all, *one.kind, *c.bodies.bunny().kind, {}, {});
  const std::vector<decide_function> tests{decide_by(by, rung::certified), decide_by(by, rung::fp32),
                                           classic::moller_trumbore};
  double first = 0;
  std::vector<double> over_gpu;
  for (std::size_t times = 0; times < segment_rows(c); ++times) {
    const io::element_set bunny = c.bodies.finer_bunny(static_cast<int>(times));
    for (const io::element_set *const segments : {&one, &cloud}) {
      const search s = search_pairs(c, *segments, bunny, false);
      const brute_force_times brute = time_brute_force(c.by, tests, *by.predicate, *segments, bunny, c.budget, c.runs);
      const double core_time = brute.of[1].time, baseline = brute.of[2].time;
      if (first == 0)
        first = core_time;
      device_cells gpu = ask_device(c, *segments, bunny, s.found.pairs, core_time);
      over_gpu.push_back(gpu.core_over_gpu);
      t.rows.push_back({of_count(bunny.elements), of_count(segments->elements), of_count(s.found.pairs),
                        of_ratio(core_time / first), of_ratio(core_time / baseline),
                        of_ratio(brute.of[0].time / baseline), of_ratio(core_time / s.time)});
      t.rows.back().insert(t.rows.back().end(), gpu.cells.begin(), gpu.cells.end());
    }
    c.advance();
  }
  add_claim(c, over_gpu, t);
  to.tables.push_back(std::move(t));
  to.figures.push_back({1, fmt::format("Triangle - {} intersection", c.bodies.bunny_name()), large_triangle(c), {}});
}

} // namespace meetc::bench
