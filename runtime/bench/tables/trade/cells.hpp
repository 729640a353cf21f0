// bench/tables/trade/cells.hpp: the cost of each method of deciding a predicate on a list of pairs, and its errors there.
#ifndef MEETC_BENCH_TABLES_TRADE_CELLS_HPP
#define MEETC_BENCH_TABLES_TRADE_CELLS_HPP

#include "meet/bench/tables/trade_point.hpp"
#include "meet/bench/truth/near_pairs.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

// All that decide the predicate: the rungs that it was generated for, and the paper's way where there is one.
std::vector<trade_method> methods_of(const predicate_info &p);

wrongness wrongness_of(const element_pairs &pairs, const trade_method &method, const std::vector<answer> &given,
                       const std::vector<answer> &exact);

struct trade_result {
  std::vector<trade_point> points;
  std::uint64_t hits = 0;
  int repetitions = 0;
};

// Times all methods by turns, and compares their answers with those of exact, which the predicate must have. With a
// tolerance above 0, which the predicate keeps, a further method is certified on numbers that are rounded as far as that
// allows; rounding them is no part of its time.
trade_result measure_trade(const element_pairs &pairs, const turns &how, double tolerance = 0);

// The answers of one function for all pairs.
std::vector<answer> decide_all(const element_pairs &pairs, const pair_decider &decide);

} // namespace meetc::bench

#endif
