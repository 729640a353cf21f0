#include "bench/tables/cpu/bars.hpp"

#include <fmt/format.h>

namespace meetc::bench {

table table_of(const std::vector<bar> &bars) {
  table t;
  t.name = "bars";
  t.title = "Speeds to reach";
  t.columns = {{"work", "work"}, {"figure", "figure"}, {"bar", "bar"}, {"measured", "measured"}, {"met", "met"}};
  for (const bar &b : bars) {
    cell measured = missing(b.why_not), met = missing("-");
    if (b.measured) {
      measured = of_ratio(*b.measured);
      measured.text += " " + b.unit;
      met = {b.met() ? "yes" : "**no**", b.met()};
    }
    t.rows.push_back({of_words(b.work), of_words(b.figure),
                      of_words(fmt::format("{} {} {}", b.reach == bar::side::at_least ? "≥" : "≤", b.limit, b.unit)),
                      measured, met});
  }
  return t;
}

} // namespace meetc::bench
