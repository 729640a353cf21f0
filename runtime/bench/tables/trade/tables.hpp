// bench/tables/trade/tables.hpp: the results of `meet trade` as tables, as CSV and as a picture.
#ifndef MEETC_BENCH_TABLES_TRADE_TABLES_HPP
#define MEETC_BENCH_TABLES_TRADE_TABLES_HPP

#include "meet/bench/harness/plot.hpp"
#include "meet/bench/harness/table.hpp"
#include "meet/bench/tables/trade/cells.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace meetc::bench {

// One predicate on one family of pairs.
struct trade_cell {
  const predicate_info *by = nullptr;
  std::string family, in_words;
  double size = 1; // of the elements, to which distances are compared in the picture
  std::size_t pairs = 0;
  trade_result result;
};

// A whole query at one rung.
struct trade_query {
  std::string scene;
  rung precision = rung::fp32;
  bool device = false; // measured there, by events
  double seconds = 0, over_fp32 = 0;
  std::uint64_t candidates = 0, unsure = 0; // unsure: in fp32, of certified
  difference differs;
};

// The names of the families, each once, in the order of the cells.
std::vector<std::string> families_of(const std::vector<trade_cell> &all);

table table_of_family(const std::string &family, const std::vector<trade_cell> &all);
// For each predicate, the methods that lose everywhere: another one is faster in every family, and in none more often wrong.
table table_of_losers(const std::vector<trade_cell> &all);
table table_of_queries(const std::vector<trade_query> &all, int threads);
std::string as_csv(const std::vector<trade_cell> &all);

// Time of a pair across, and the farthest wrong answer over the size of the elements upwards, a panel for each family.
// `about` is a line that says on what it was measured.
plot plot_of_trade(const std::string &about, const std::vector<trade_cell> &all);

} // namespace meetc::bench

#endif
