// bench/harness/table.hpp: tables of results as data: columns, each with its view of a row, and rows of any type.
// A table is written as text, as Markdown and as JSON.
#ifndef MEETC_BENCH_HARNESS_TABLE_HPP
#define MEETC_BENCH_HARNESS_TABLE_HPP

#include "meet/app/text/json.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
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
cell missing(const std::string &why = "-"); // null, with a reason

struct heading {
  std::string key, title; // key: for the JSON object; title: for people, with '|' where a line may end
};

struct table {
  std::string name, title; // name: one word
  std::vector<heading> columns;
  std::vector<std::vector<cell>> rows;
  std::vector<std::string> notes;
};

// A column shows a cell for each row, or a member or a function of the row in one of the forms above.
template <class Row> struct column {
  std::string key, title; // as those of a heading
  std::function<cell(const Row &)> show;

  template <class Show>
  column(std::string k, std::string t, Show s) : key(std::move(k)), title(std::move(t)), show(s) {}
  template <class Form, class Figure>
  column(std::string k, std::string t, Form form, Figure figure)
      : key(std::move(k)), title(std::move(t)),
        show([form, figure](const Row &r) { return form(std::invoke(figure, r)); }) {}
};
template <class Row> using columns = std::vector<column<Row>>;

template <class Row>
table table_of(std::string name, std::string title, const columns<Row> &show, const std::vector<Row> &rows,
               std::vector<std::string> notes = {}) {
  table t{std::move(name), std::move(title), {}, {}, std::move(notes)};
  for (const column<Row> &c : show)
    t.columns.push_back({c.key, c.title});
  for (const Row &row : rows) {
    t.rows.emplace_back();
    for (const column<Row> &c : show)
      t.rows.back().push_back(c.show(row));
  }
  return t;
}

std::string as_text(const table &t);
std::string as_markdown(const table &t);
app::json as_json(const table &t); // an object

} // namespace meetc::bench

#endif
