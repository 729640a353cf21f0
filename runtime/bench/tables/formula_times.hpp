// bench/tables/formula_times.hpp: times of formulas on columns and on listed rows, on a CPU and on a device.
#ifndef MEETC_BENCH_TABLES_FORMULA_TIMES_HPP
#define MEETC_BENCH_TABLES_FORMULA_TIMES_HPP

#include "meet/bench/harness/table.hpp"

#include <string>
#include <vector>

namespace meetc::bench {

// The formulas that are measured.
inline constexpr const char *measured_formulas[] = {"norm2(meet(sphere, sphere))", "meet(sphere, sphere)",
                                                    "norm2(meet(sphere, plane))", "meet(plane, line)",
                                                    "norm2(meet(circle, circle))"};

// Seconds: column by column, beside a copy of as many bytes; and on listed rows, beside what gathers them and writes a sum for
// each value.
struct formula_times {
  std::string formula;
  int in, out; // numbers
  double columns, copy, listed, gather;
};

table table_of_formulas(const std::string &title, const std::vector<formula_times> &rows, const std::string &note);

} // namespace meetc::bench

#endif
