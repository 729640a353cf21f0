// bench/tables/paper/parts.hpp: the parts of `meet bench paper`: what they share, and what each adds to the result.
#ifndef MEETC_BENCH_TABLES_PAPER_PARTS_HPP
#define MEETC_BENCH_TABLES_PAPER_PARTS_HPP

#include "app/collide_sets.hpp"
#include "bench/harness/chart.hpp"
#include "bench/harness/scaling.hpp"
#include "bench/harness/table.hpp"
#include "bench/scenes/paper_bodies.hpp"
#include "bench/tables/paper/brute_force.hpp"
#include "bench/tables/paper/device.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

struct paper_context {
  const catalogue &all;
  const paper_bodies &bodies;
  bench_device *device; // null: none
  yardstick &by;
  bool quick;
  int threads, runs;
  std::uint64_t budget;          // pairs that one timing of brute force may take
  std::function<void()> advance; // called after each row
};

struct paper_scaling {
  std::string name, words; // one word; "Armadillo triangles hit grow as ..."
  power_fit fit;
};

// A scene with two sets and their hits, for a picture.
struct paper_scene {
  io::element_set a, b;
  std::vector<std::uint8_t> hit_a, hit_b;
  std::string name_a, name_b;
  picture::colour base_a, base_b, hit_colour_a, hit_colour_b;
};

struct paper_figure {
  int number = 0;
  std::string title;
  std::optional<paper_scene> scene; // or
  std::optional<chart> plot;
};

struct paper_result {
  std::vector<table> tables;
  std::vector<paper_scaling> scalings;
  std::vector<paper_figure> figures;
};

// The number of rows for which each part will call `advance`.
std::size_t mesh_rows(const paper_context &c);
std::size_t sphere_rows(const paper_context &c);
std::size_t segment_rows(const paper_context &c);

void add_meshes(const paper_context &c, paper_result &to);   // section 4.1, figures 1 to 3; 4.3, figure 6
void add_spheres(const paper_context &c, paper_result &to);  // section 4.2, figures 4 and 5
void add_segments(const paper_context &c, paper_result &to); // the table of times in section 4.2

// ---- one row's measurements

// All touching pairs, certified, as `meet collide` finds them.
struct search {
  app::answers found;
  double time = 0; // on one core, with both sets prepared, certified; in yardsticks
  double certified_over_fp32 = 0;
};
search search_pairs(const paper_context &c, const io::element_set &a, const io::element_set &b, bool keep);

// The cells "GPU", "with transfers" and "one core / GPU". The time with transfers is in yardsticks, 0 without a device.
// Throws failure where the device's count is not `pairs`.
struct device_cells {
  std::vector<cell> cells;
  double time = 0, core_over_gpu = 0;
};
device_cells ask_device(const paper_context &c, const io::element_set &a, const io::element_set &b, std::uint64_t pairs,
                        double one_core);
std::vector<column> device_columns();
// Adds the paper's claim next to the ratios of a table's rows; adds nothing without a device.
void add_claim(const paper_context &c, const std::vector<double> &core_over_gpu, table &to);

decide_function decide_by(const app::choice &by, rung precision);

} // namespace meetc::bench

#endif
