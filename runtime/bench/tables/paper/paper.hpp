// bench/tables/paper/paper.hpp: the parts of `meet bench paper`: their common types, and the addition of each to the result.
#ifndef MEETC_BENCH_TABLES_PAPER_PAPER_HPP
#define MEETC_BENCH_TABLES_PAPER_PAPER_HPP

#include "meet/app/query/collide_sets.hpp"
#include "meet/bench/harness/chart.hpp"
#include "meet/bench/harness/scaling.hpp"
#include "meet/bench/harness/table.hpp"
#include "meet/bench/scenes/paper_bodies.hpp"
#include "meet/bench/tables/device.hpp"
#include "meet/bench/tables/paper/brute_force.hpp"

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

struct paper_context {
  const catalogue &all;
  const paper_bodies &bodies;
  bench_device *device; // null: none
  bool quick;
  int threads, runs;
  std::uint64_t budget;          // pairs that one timing of brute force may take
  std::function<void()> advance; // called after each row
};

struct paper_scaling {
  std::string name, words; // one word; "Armadillo triangles hit grow as ..."
  power_fit fit;
};

struct paper_figure {
  int number = 0;
  std::string title;
  std::function<void(const std::filesystem::path &to)> draw;
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

// Two sets, and what was found and timed of them. Times of the CPU are multiples of the reference work's in the same turns.
struct paper_row {
  std::uint64_t a = 0, b = 0;                    // elements
  std::uint64_t pairs = 0, hit_a = 0, hit_b = 0; // certified, as `meet collide` finds them
  std::uint64_t expected = 0;                    // pairs on average, where that is known
  double search = 0;                             // certified, on one core, with making both sets ready
  double search_certified_over_fp32 = 0;         // of sets that were used before
  std::vector<double> tests;                     // every pair on one core, by each test
  std::vector<difference> wrong;                 // beside the first test, certified
  std::uint64_t compared = 0;                    // pairs of these
  std::optional<device_time> device;             // every pair on a device
  double device_search = 0;                      // its time with transfers
  double core_over_device = 0;                   // the second test over that

  double core() const { return tests[1]; } // the paper's way: the conformal predicate in fp32
  double over(std::size_t test, std::size_t other) const { return tests[test] / tests[other]; }
};

// The first of the tests is certified, the second is fp32. `found` gets what was found. Throws app::failure with
// app::check_failed where two of those that promise the truth differ.
paper_row measure_row(const paper_context &c, const io::element_set &a, const io::element_set &b,
                      const std::vector<pair_test> &tests, app::answers &found);
// Certified, then fp32, then these.
std::vector<pair_test> conformal_and(const paper_context &c, const io::element_set &a, const io::element_set &b,
                                     std::initializer_list<decide_function> classic);
app::answers search_pairs(const paper_context &c, const io::element_set &a, const io::element_set &b, bool keep);

// Columns that several tables have; `first` is the first row.
column<paper_row> core_column(const std::vector<paper_row> &rows);
columns<paper_row> with_device(columns<paper_row> to);
// The paper's claim next to the ratios of a table's rows; empty without a device.
std::vector<std::string> claim_of(const paper_context &c, const std::vector<paper_row> &rows);

// The curves of the searches over the number of elements, as multiples of the first row's time on one core.
std::vector<curve> curves_of(const paper_context &c, const std::vector<paper_row> &rows);
std::vector<std::pair<double, double>> points_of(const std::vector<paper_row> &rows, double over,
                                                 const std::function<double(const paper_row &)> &time);
paper_figure figure_of(const paper_context &c, int number, chart drawn);

// A set with its hits, for a picture.
struct painted_set {
  io::element_set set;
  std::vector<std::uint8_t> hit;
  std::string name;
  picture::colour base, hit_colour;
};
paper_figure figure_of(const paper_context &c, int number, std::string title, std::vector<painted_set> sides);

} // namespace meetc::bench

#endif
