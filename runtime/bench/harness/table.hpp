// bench/harness/table.hpp: a table of results as text, as Markdown and as JSON.
#ifndef MEETC_BENCH_HARNESS_TABLE_HPP
#define MEETC_BENCH_HARNESS_TABLE_HPP

#include "app/json.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace meetc::bench {

struct cell {
  std::string text;
  app::json value;
};
cell of_count(std::uint64_t n); // 345,944
cell of_ratio(double x);        // three digits; "-" and null where it is not finite
cell of_milliseconds(double seconds);
cell of_nanoseconds(double seconds);
cell of_rate(double pairs_a_second); // in 10^12 pairs a second
cell of_share(double x);             // in percent; in JSON as it is
cell of_words(const std::string &words);
cell missing(const std::string &why); // null, with a reason

struct column {
  std::string key, title; // key: for the JSON object; title: for people, with '|' where a line may end
};

struct table {
  std::string name, title; // name: one word
  std::vector<column> columns;
  std::vector<std::vector<cell>> rows;
  std::vector<std::string> notes;
};

std::string as_text(const table &t);
std::string as_markdown(const table &t);
app::json as_json(const table &t); // an object

} // namespace meetc::bench

#endif
