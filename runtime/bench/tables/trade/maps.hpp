// bench/tables/trade/maps.hpp: wrong and unsure answers of the plain and the bounded rungs over scale, place and nearness to a
// contact, as maps.
#ifndef MEETC_BENCH_TABLES_TRADE_MAPS_HPP
#define MEETC_BENCH_TABLES_TRADE_MAPS_HPP

#include "meet/bench/harness/plot.hpp"
#include "meetc/support.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace meetc::bench {

// One axis is the nearness to a contact, in bits; the other is the scale or the offset.
struct trade_map {
  std::string rung;          // such as "fp32"
  bool unsure = false;       // else wrong
  std::vector<double> share; // of the pairs of a cell: columns x rows, one row after another
};

struct trade_maps {
  enum class axis : std::uint8_t { scale, offset } across = axis::scale;
  std::vector<std::string> columns; // labels
  std::vector<int> bits;            // of the rows
  std::vector<trade_map> maps; // wrong in fp32, fp64 and fp64x2, then unsure in fp32 and fp64, where there are such
  // The largest share of its proved distance that a wrong answer reached; 0 where nothing is proved or wrong.
  double seen_of_proved = 0;
};

// n pairs in each cell. The predicate must have exact, and hulls that are known. The same on every machine, except for
// what is unsure, which depends on the instruction set.
trade_maps map_trade(const predicate_info &p, trade_maps::axis across, std::size_t n);

// One picture with the maps of both axes.
plot plot_of_maps(const std::string &title, const std::vector<trade_maps> &all);

} // namespace meetc::bench

#endif
