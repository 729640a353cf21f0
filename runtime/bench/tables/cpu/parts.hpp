// bench/tables/cpu/parts.hpp: the families of `meet bench cpu`: what they share, and what each adds to the result.
#ifndef MEETC_BENCH_TABLES_CPU_PARTS_HPP
#define MEETC_BENCH_TABLES_CPU_PARTS_HPP

#include "bench/harness/interleaved.hpp"
#include "bench/harness/table.hpp"
#include "bench/scenes/cpu_sets.hpp"
#include "bench/tables/cpu/bars.hpp"

#include <vector>

namespace meetc::bench {

struct cpu_context {
  std::vector<const catalogue *> kernels; // for each instruction set that is measured; the best is the last
  const cpu_sets &sets;
  int threads, repetitions;
  bool quick;

  const catalogue &best() const { return *kernels.back(); }
  interleaved_options one_thread(double most_seconds) const { return {repetitions, 1, most_seconds}; }
  interleaved_options all_threads(double most_seconds) const { return {repetitions, threads, most_seconds}; }
};

struct cpu_result {
  std::vector<table> tables;
  std::vector<bar> bars;
};

void measure_precision(const cpu_context &c, cpu_result &to);  // what certainty costs in a query
void measure_candidates(const cpu_context &c, cpu_result &to); // queries, beside other libraries
void measure_balls(const cpu_context &c, cpu_result &to);      // many balls
void measure_families(const cpu_context &c, cpu_result &to);   // triangle pairs by families, beside CGAL

} // namespace meetc::bench

#endif
