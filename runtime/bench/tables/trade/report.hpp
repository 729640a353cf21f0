// bench/tables/trade/report.hpp: what `meet trade` measured, as tables, as CSV and as a plot.
#ifndef MEETC_BENCH_TABLES_TRADE_REPORT_HPP
#define MEETC_BENCH_TABLES_TRADE_REPORT_HPP

#include "bench/harness/table.hpp"
#include "bench/tables/trade/measure.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace meetc::bench {

// One predicate on one family of pairs.
struct trade_cell {
  const predicate_info *by = nullptr;
  std::string family, in_words;
  double size = 1; // of the elements, to which distances are compared in the plot
  std::size_t pairs = 0;
  trade_result result;
};

// A whole query at one rung.
struct trade_query {
  std::string scene;
  rung precision = rung::fp32;
  double seconds = 0;
  std::uint64_t pairs = 0, candidates = 0, false_hits = 0, missed = 0;
  std::uint64_t unsure = 0; // in fp32, of certified
  bool device = false;      // measured there, by events
};

table table_of(const std::string &family, const std::vector<trade_cell> &all);
// For each predicate, the methods that lose everywhere: another one is faster in every family, and in none more often wrong.
table losers_of(const std::vector<trade_cell> &all);
table table_of(const std::vector<trade_query> &all, int threads);
std::string as_csv(const std::vector<trade_cell> &all);

// Time of a pair across, and the farthest wrong answer over the size of the elements upwards, a panel for each family.
// `about` is a line that says on what it was measured. Throws app::failure where gnuplot is missing or fails.
void draw_trade(const std::filesystem::path &to, const std::string &about, const std::vector<trade_cell> &all);

} // namespace meetc::bench

#endif
