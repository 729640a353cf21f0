// CSV: a header line that names a kind's stored numbers, then one row of numbers for each element. Lines that start
// with # are comments; blank lines may end the file.
#include "meet/io/csv_header.hpp"
#include "meet/io/elements/readers.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/mesh.hpp"
#include "meet/io/text/cursor.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace meetc::io {

namespace {

struct rows_part {
  std::vector<float> rows;
  rounded_numbers rounded;
  bool blank_before = false, blank_after = false; // whether a blank line is before the first row, or after the last one
};

class row_parser {
public:
  row_parser(const text_file &text, std::string_view piece, const csv_header &header, const misplaced *fault)
      : text_(text), c_(piece), header_(header), fault_(fault), row_(header.names.size()) {}

  rows_part parse() {
    for (; !c_.done(); ++c_.at) {
      const char *const start = c_.at;
      c_.skip_blanks();
      if (c_.at_line_end()) {
        (part_.rows.empty() ? part_.blank_before : part_.blank_after) = true;
        continue;
      }
      if (*c_.at == '#') {
        c_.skip_line();
        continue;
      }
      // A blank line inside a table more often means a damaged file than a choice.
      if (part_.blank_after)
        text_.fail(start, "a row after a blank line");
      if (elements() == most_elements)
        text_.fail(start, fmt::format("more than {} rows", most_elements));
      rounded_numbers moved;
      c_.at = start;
      if (!plain_row(moved)) {
        moved = {};
        c_.at = start;
        any_row(c_.rest(), start, moved);
      }
      check(start);
      part_.rounded.add(moved);
      part_.rows.insert(part_.rows.end(), row_.begin(), row_.end());
    }
    if (part_.rows.empty())
      part_.blank_after = part_.blank_before;
    return std::move(part_);
  }

private:
  std::size_t elements() const { return part_.rows.size() / row_.size(); }

  // Reads a row without quotes: decimals, and any text in the columns that are left out. False: any_row() must read it.
  bool plain_row(rounded_numbers &moved) {
    const char separator = header_.separator;
    for (std::size_t k = 0; k < header_.fields.size(); ++k) {
      if (k > 0) {
        if (*c_.at != separator)
          return false;
        ++c_.at;
      }
      skip_blanks();
      if (const int field = header_.fields[k]; field >= 0) {
        const char *const stop = read_decimal(c_.at, row_[static_cast<std::size_t>(field)], moved);
        if (!stop)
          return false;
        c_.at = stop;
        skip_blanks();
      } else {
        while (*c_.at != separator && *c_.at != '\n' && *c_.at != '"')
          ++c_.at;
      }
    }
    return c_.at_line_end();
  }
  void skip_blanks() {
    while (*c_.at == ' ' || *c_.at == '\r' || (*c_.at == '\t' && header_.separator != '\t'))
      ++c_.at;
  }

  void any_row(std::string_view line, const char *start, rounded_numbers &moved) {
    if (!split_fields(line, header_.separator, words_))
      text_.fail(start, "a quote is not closed");
    if (words_.size() != header_.fields.size())
      text_.fail(start, fmt::format("{} fields, but the header {} names {}", words_.size(), header_.text,
                                    header_.fields.size()));
    for (std::size_t k = 0; k < words_.size(); ++k) {
      if (header_.fields[k] < 0)
        continue;
      const auto f = static_cast<std::size_t>(header_.fields[k]);
      if (words_[k].empty())
        text_.fail(start, fmt::format("{} is empty", header_.names[f]));
      std::string with_point(words_[k]);
      if (header_.separator == ';' && with_point.find('.') == std::string::npos)
        if (const std::size_t comma = with_point.find(','); comma != std::string::npos)
          with_point[comma] = '.';
      if (!read_decimal_word(with_point, row_[f], moved))
        text_.fail(start, fmt::format("{} is {}, not a number", header_.names[f], quote(words_[k])));
      if (!std::isfinite(row_[f])) {
        double read = 0;
        parse_decimal(with_point, precision::float64, read);
        unfit_ = f < unfit_.first ? std::pair(f, read) : unfit_;
      }
    }
  }

  void check(const char *start) {
    const auto fail = [&](std::string_view what) {
      text_.fail(start, fmt::format("{} {}: {}", header_.kind->name, elements(), what));
    };
    if (const auto [f, read] = unfit_; f < row_.size())
      fail(describe_non_finite(header_.names[f], read, row_[f]));
    if (const char *const fault = header_.kind->fault ? header_.kind->fault(row_.data()) : nullptr)
      fail(fault);
    if (fault_ && fault_->row == elements())
      fail(fault_->what);
  }

  const text_file &text_;
  cursor c_;
  const csv_header &header_;
  const misplaced *fault_;
  std::vector<float> row_;
  std::pair<std::size_t, double> unfit_{static_cast<std::size_t>(-1), 0}; // the first field that is not finite
  std::vector<std::string_view> words_;
  rows_part part_;
};

// Whether a row follows a blank line of an earlier piece.
bool rows_after_blank(const std::vector<rows_part> &parts) {
  bool any = false, blank = false;
  for (const rows_part &p : parts) {
    if (!p.rows.empty() && any && (blank || p.blank_before))
      return true;
    any = any || !p.rows.empty();
    blank = p.rows.empty() ? blank || p.blank_after : p.blank_after;
  }
  return false;
}

} // namespace

element_set read_csv(const file_bytes &file, const read_request &q) {
  line_reader lines(file.text(), file.name);
  std::string_view line;
  const auto holds_text = [](std::string_view l) { return !trim(l).empty() && trim(l).front() != '#'; };
  bool found = false;
  while (!found && lines.next(line))
    found = holds_text(line);
  const csv_header header = read_csv_header(fmt::format("{}:{}", file.name, std::max<std::size_t>(lines.number(), 1)),
                                            found ? trim(line) : std::string_view{}, q);
  text_file text(file, q.by, lines.offset(), lines.number() + 1);
  const auto parse = [&](std::string_view piece, std::size_t, bool) {
    return row_parser(text, piece, header, q.fault).parse();
  };
  std::vector<rows_part> parts;
  if (!q.fault)
    parts = parse_pieces<rows_part>(text, text.pieces(at_any_line()), parse);
  if (q.fault || rows_after_blank(parts))
    parts = parse_pieces<rows_part>(text, {}, parse);
  mesh_part rows = join_rows(parts, q.by.threads);
  element_set set;
  set.kind = header.kind;
  set.data = std::move(rows.xyz);
  set.rounded = rows.rounded;
  set.elements = set.items = set.data.size() / static_cast<std::size_t>(set.kind->fields);
  if (set.elements > most_elements)
    throw error(fmt::format("{}: more than {} rows", file.name, most_elements));
  if (!header.left_out.empty())
    set.notes.push_back(fmt::format("left out: the columns {}", header.left_out));
  return set;
}

} // namespace meetc::io
