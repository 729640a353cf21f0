// bench/tables/cpu/bars.hpp: the speeds that are to be reached, with the measured ones beside them.
#ifndef MEETC_BENCH_TABLES_CPU_BARS_HPP
#define MEETC_BENCH_TABLES_CPU_BARS_HPP

#include "bench/harness/table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

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

table table_of(const std::vector<bar> &bars);

} // namespace meetc::bench

#endif
