// CSV: a header line that names a kind's stored numbers, then one row of numbers for each element. Lines that start
// with # are comments; blank lines may end the file.
#include "io/error.hpp"
#include "io/mesh_builder.hpp"
#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace meetc::io {

namespace {

// The fields between commas, trimmed.
void split(std::string_view line, std::vector<std::string_view> &out) {
  out.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    out.push_back(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos)
      return;
    line.remove_prefix(comma + 1);
  }
}

const kind_info &match_header(const line_reader &lines, std::string_view header,
                              std::span<const kind_info *const> kinds) {
  std::vector<std::string_view> found, stored;
  split(header, found);
  std::string supported;
  for (const kind_info *const kind : kinds) {
    split(kind->csv, stored);
    if (std::ranges::equal(found, stored))
      return *kind;
    supported += fmt::format("{}{} ({})", supported.empty() ? "" : "; ", kind->csv, kind->name);
  }
  lines.fail(fmt::format("unknown header {}; supported: {}", quote(header), supported));
}

class row_reader {
public:
  row_reader(const kind_info &kind, const transform &move, const std::string &file)
      : kind_(kind), asked_(move), move_(kind, move, file),
        target_(move.any() ? precision::float64 : precision::float32), read_(static_cast<std::size_t>(kind.fields)),
        placed_(read_.size()) {
    split(kind.csv, names_);
  }

  // The checked row of element `i`; valid until the next call.
  std::span<const float> row(const line_reader &lines, std::string_view line, std::size_t i) {
    split(line, words_);
    if (words_.size() != read_.size())
      lines.fail(fmt::format("{} fields, but the header {} names {}", words_.size(), kind_.csv, read_.size()));
    for (std::size_t f = 0; f < words_.size(); ++f) {
      if (words_[f].empty())
        lines.fail(fmt::format("{} is empty", names_[f]));
      if (!parse_decimal(words_[f], target_, read_[f]))
        lines.fail(fmt::format("{} is {}, not a number", names_[f], quote(words_[f])));
    }
    move_.apply(read_, placed_);
    for (std::size_t f = 0; f < placed_.size(); ++f)
      if (!std::isfinite(placed_[f]))
        lines.fail(
            fmt::format("{} {}: {}", kind_.name, i, describe_non_finite(names_[f], read_[f], placed_[f], asked_)));
    if (const char *const fault = kind_.fault ? kind_.fault(placed_.data()) : nullptr)
      lines.fail(fmt::format("{} {}: {}", kind_.name, i, fault));
    return placed_;
  }

private:
  const kind_info &kind_;
  const transform &asked_;
  row_transform move_;
  precision target_;
  std::vector<double> read_;
  std::vector<float> placed_;
  std::vector<std::string_view> names_, words_;
};

bool holds_text(std::string_view line) {
  const std::string_view text = trim(line);
  return !text.empty() && text.front() != '#';
}

} // namespace

element_set read_csv(const file_bytes &file, std::span<const kind_info *const> kinds, const transform &move) {
  line_reader lines(file.text(), file.name);
  std::string_view line;
  bool found = false;
  while (!found && lines.next(line))
    found = holds_text(line);
  if (!found)
    line = {};
  element_set set;
  set.kind = &match_header(lines, trim(line), kinds);
  row_reader rows(*set.kind, move, file.name);
  bool blank = false;
  while (lines.next(line)) {
    if (!holds_text(line)) {
      blank = blank || trim(line).empty();
      continue;
    }
    // A blank line inside a table more often means a damaged file than a choice.
    if (blank)
      lines.fail("a row after a blank line");
    if (set.elements == most_elements)
      lines.fail(fmt::format("more than {} rows", most_elements));
    const std::span<const float> row = rows.row(lines, line, set.elements);
    set.data.insert(set.data.end(), row.begin(), row.end());
    ++set.elements;
  }
  set.items = set.elements;
  return set;
}

} // namespace meetc::io
