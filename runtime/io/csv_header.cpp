#include "meet/io/csv_header.hpp"

#include "meet/io/files/error.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::io {

namespace {

std::vector<std::string> names_of(const kind_info &kind) {
  std::vector<std::string_view> fields;
  split_fields(kind.csv, ',', fields);
  return {fields.begin(), fields.end()};
}

// The column of each name; empty where one is missing or there twice.
std::vector<std::size_t> columns_of(const std::vector<std::string> &names, const std::vector<std::string> &columns) {
  std::vector<std::size_t> out;
  for (const std::string &name : names) {
    // "radius" says more than "r", which may also be red.
    const bool radius = name == "r" && std::ranges::count(columns, "radius") == 1;
    const std::string_view wanted = radius ? "radius" : std::string_view(name);
    if (std::ranges::count(columns, wanted) != 1)
      return {};
    out.push_back(static_cast<std::size_t>(std::ranges::find(columns, wanted) - columns.begin()));
  }
  return out;
}

struct fit {
  const kind_info *kind;
  std::vector<std::string> names;
  std::vector<std::size_t> columns;

  bool holds(const fit &other) const {
    return std::ranges::all_of(other.columns,
                               [&](std::size_t c) { return std::ranges::find(columns, c) != columns.end(); });
  }
};

std::string quoted_list(const std::vector<fit> &fits) {
  std::string out;
  for (const fit &f : fits)
    out += fmt::format("{}{}", out.empty() ? "" : " or ", f.kind->name);
  return out;
}

} // namespace

bool split_fields(std::string_view line, char separator, std::vector<std::string_view> &out) {
  out.clear();
  const auto blank = [separator](char c) { return c == ' ' || c == '\r' || (c == '\t' && separator != '\t'); };
  for (;;) {
    while (!line.empty() && blank(line.front()))
      line.remove_prefix(1);
    std::string_view field;
    if (line.starts_with('"')) {
      const std::size_t close = line.find('"', 1);
      if (close == std::string_view::npos)
        return false;
      field = line.substr(1, close - 1);
      line.remove_prefix(close + 1);
      while (!line.empty() && blank(line.front()))
        line.remove_prefix(1);
      if (!line.empty() && line.front() != separator)
        return false;
    } else {
      field = line.substr(0, line.find(separator));
      line.remove_prefix(field.size());
    }
    while (!field.empty() && blank(field.back()))
      field.remove_suffix(1);
    while (!field.empty() && blank(field.front()))
      field.remove_prefix(1);
    out.push_back(field);
    if (line.empty())
      return true;
    line.remove_prefix(1);
  }
}

csv_header read_csv_header(const std::string &place, std::string_view line, const read_request &q) {
  csv_header out;
  out.text = line;
  out.separator = line.find(';') != std::string_view::npos    ? ';'
                  : line.find(',') != std::string_view::npos  ? ','
                  : line.find('\t') != std::string_view::npos ? '\t'
                                                              : ',';
  std::vector<std::string_view> fields;
  if (!split_fields(line, out.separator, fields))
    throw error(fmt::format("{}: a quote in the header {} is not closed", place, quote(line)));
  std::vector<std::string> columns;
  for (const std::string_view f : fields)
    columns.push_back(lower_case(f));

  std::vector<fit> fits;
  std::string supported;
  for (const kind_info *const kind : q.kinds)
    for (const std::string &name : names_of(*kind))
      for (const std::string &column : {name, std::string("radius")})
        if (std::ranges::count(columns, column) > 1)
          throw error(fmt::format("{}: the header {} has the column {} twice", place, quote(line), quote(column)));
  for (const kind_info *const kind : q.kinds) {
    supported += fmt::format("{}{} ({})", supported.empty() ? "" : "; ", kind->csv, kind->name);
    std::vector<std::string> names = names_of(*kind);
    std::vector<std::size_t> at = columns_of(names, columns);
    if (!at.empty() && (q.kind.empty() || q.kind == kind->name))
      fits.push_back({kind, std::move(names), std::move(at)});
  }
  if (fits.empty() && !q.kind.empty() && q.named(q.kind))
    throw error(fmt::format("{}: the header {} does not have the columns {} of --kind-{} {}", place, quote(line),
                            q.named(q.kind)->csv, q.side, q.kind));
  if (fits.empty())
    throw error(fmt::format("{}: unknown header {}; supported: {}", place, quote(line), supported));
  const auto has = [&](std::string_view name) { return std::ranges::find(columns, name) != columns.end(); };
  std::vector<fit> largest;
  for (const fit &f : fits) {
    const bool contained = std::ranges::any_of(fits, [&](const fit &g) {
      return g.columns.size() > f.columns.size() && g.holds(f) &&
             !(has("g") && has("b") && has("r") && !has("radius") && std::ranges::find(g.names, "r") != g.names.end());
    });
    if (!contained)
      largest.push_back(f);
  }
  if (largest.size() > 1)
    throw error(fmt::format("{}: the header {} fits {}; choose with --kind-{}", place, quote(line),
                            quoted_list(largest), q.side));
  const fit &chosen = largest.front();
  out.kind = chosen.kind;
  out.names = chosen.names;
  out.fields.assign(columns.size(), -1);
  for (std::size_t f = 0; f < chosen.columns.size(); ++f)
    out.fields[chosen.columns[f]] = static_cast<int>(f);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (out.fields[c] < 0)
      out.left_out += fmt::format("{}{}", out.left_out.empty() ? "" : ", ", quote(fields[c]));
  return out;
}

} // namespace meetc::io
