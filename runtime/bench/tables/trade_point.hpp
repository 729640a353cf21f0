// bench/tables/trade_point.hpp: the cost and the errors of one method of deciding, as measured.
#ifndef MEETC_BENCH_TABLES_TRADE_POINT_HPP
#define MEETC_BENCH_TABLES_TRADE_POINT_HPP

#include "meet/bench/harness/method.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace meetc::bench {

// A method of deciding: a rung, or the paper's own way (bench/baselines/paper_way.hpp).
struct trade_method {
  std::string name;
  pair_decider decide;
  std::optional<rung> precision; // none: the paper's way, or a filter alone
  double grid = 0;               // the numbers are rounded to its multiples first (pose::grid); 0: they are as they are

  bool promises_truth() const { return precision && never_wrong(*precision); }
};

// The errors of the answers of one method; lengths are those of the pairs' own unit.
struct wrongness {
  difference differs;
  double farthest = 0;          // the longest distance from being right, over the wrong answers
  double farthest_in_ulps = 0;  // the same in units in the last place of the pair's largest number
  std::optional<double> proved; // the largest proved distance, over all pairs; infinite where there is none
};

struct trade_point {
  trade_method method;
  double seconds = 0; // for one pair
  wrongness wrong = {};
  std::optional<std::uint64_t> unsure = {}; // certified: the pairs that its first rung left unsure
  std::size_t pairs = 0;                    // of which the method was asked, the first ones; 0: all
  bool on_device = false;
};

} // namespace meetc::bench

#endif
