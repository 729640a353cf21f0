// bench/tables/cpu/cpu.hpp: the families of `meet bench cpu`: their common types, and the addition of each to the result.
#ifndef MEETC_BENCH_TABLES_CPU_CPU_HPP
#define MEETC_BENCH_TABLES_CPU_CPU_HPP

#include "meet/bench/harness/method.hpp"
#include "meet/bench/harness/table.hpp"
#include "meet/bench/scenes/cpu_sets.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

struct cpu_context {
  std::vector<const catalogue *> kernels; // for each instruction set that is measured; the best is the last
  const cpu_sets &sets;
  int threads, repetitions;
  bool quick;

  const catalogue &best() const { return *kernels.back(); }
  const char *best_name() const { return name_of(best().compiled_for); }
  turns for_seconds(double most) const { return {repetitions, most}; }
};

// A speed that is to be reached, with the measured one.
struct bar {
  enum class side { at_least, at_most };

  std::string work, figure; // "bunny x armadillo": "collide, certified / plain fp32"
  side reach;
  double limit;
  std::string unit;                    // "x", "ms"
  std::optional<double> measured = {}; // empty where this run could not
  std::string why_not = {};            // then

  bool met() const { return measured && (reach == side::at_least ? *measured >= limit : *measured <= limit); }
};
table table_of_bars(const std::vector<bar> &bars);

struct cpu_result {
  std::vector<table> tables;
  std::vector<bar> bars;
};

void measure_precision(const cpu_context &c, cpu_result &to);    // what certainty costs in a query
void measure_candidates(const cpu_context &c, cpu_result &to);   // queries, beside other libraries
void measure_balls(const cpu_context &c, cpu_result &to);        // many balls
void measure_moved_bodies(const cpu_context &c, cpu_result &to); // many bodies
void measure_contacts(const cpu_context &c, cpu_result &to);     // where meshes meet, and cross themselves
void measure_refit(const cpu_context &c, cpu_result &to);        // sets that move
void measure_cancelling(const cpu_context &c, cpu_result &to);   // calls that are cancelled
void measure_families(const cpu_context &c, cpu_result &to);     // triangle pairs by families, beside CGAL

} // namespace meetc::bench

#endif
