#include "meet/bench/tables/formula_times.hpp"

#include "meet/bench/harness/report.hpp"

namespace meetc::bench {

table table_of_formulas(const std::string &title, const std::vector<formula_times> &rows, const std::string &note) {
  using row = formula_times;
  return table_of<row>(
      "formulas", title,
      {{"formula", "formula", of_words, &row::formula},
       {"in", "numbers in", [](const row &x) { return of_count(static_cast<std::uint64_t>(x.in)); }},
       {"out", "numbers out", [](const row &x) { return of_count(static_cast<std::uint64_t>(x.out)); }},
       {"columns", "columns, ms", of_milliseconds, &row::columns},
       {"copy", "copy, ms", of_milliseconds, &row::copy},
       {"share_of_copy", "copy / columns", [](const row &x) { return of_ratio(x.copy / x.columns); }},
       {"listed", "listed, ms", of_milliseconds, &row::listed},
       {"gather", "gather, ms", of_milliseconds, &row::gather},
       {"share_of_gather", "gather / listed", [](const row &x) { return of_ratio(x.gather / x.listed); }}},
      rows,
      {note +
       " Copy: as many bytes read and written. Listed: random rows of columns. Gather: the same rows read, and a sum "
       "written for each value."});
}

} // namespace meetc::bench
