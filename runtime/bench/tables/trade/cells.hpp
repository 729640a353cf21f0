// bench/tables/trade/cells.hpp: the cost of each method of deciding a predicate on a list of pairs, and its errors there.
#ifndef MEETC_BENCH_TABLES_TRADE_CELLS_HPP
#define MEETC_BENCH_TABLES_TRADE_CELLS_HPP

#include "bench/harness/method.hpp"
#include "bench/truth/near_pairs.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

// A method of deciding: a rung, or the paper's own way (bench/baselines/paper_way.hpp).
struct trade_method {
  std::string name;
  decide_function decide = nullptr;
  std::optional<rung> precision; // none: the paper's way, or a filter alone
  double grid = 0;               // the numbers are rounded to its multiples first (pose::grid); 0: they are as they are

  bool promises_truth() const { return precision && never_wrong(*precision); }
};

// All that decide the predicate: the rungs that it was generated for, and the paper's way where there is one.
std::vector<trade_method> methods_of(const predicate_info &p);

// How wrong the answers of one method are; lengths are those of the pairs' own unit.
struct wrongness {
  difference differs;
  double farthest = 0;          // the longest distance from being right, over the wrong answers
  double farthest_in_ulps = 0;  // the same in units in the last place of the pair's largest number
  std::optional<double> proved; // the largest proved distance, over all pairs; infinite where there is none
};
wrongness wrongness_of(const element_pairs &pairs, const trade_method &method, const std::vector<answer> &given,
                       const std::vector<answer> &exact);

struct trade_point {
  trade_method method;
  double seconds = 0; // for one pair
  wrongness wrong = {};
  std::optional<std::uint64_t> unsure = {}; // certified: the pairs that its first rung left unsure
  std::size_t pairs = 0;                    // of which the method was asked, the first ones; 0: all
  bool on_device = false;
};

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
std::vector<answer> decide_all(const element_pairs &pairs, decide_function decide);

} // namespace meetc::bench

#endif
