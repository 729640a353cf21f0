// The ascii body of a PLY, and that of an OFF: each line that is not blank is a row.
//
// A piece of the text must know the number of its first row, so the lines are counted first. If their number is not
// that of the header, the text is read as one piece, which finds the place of the fault.
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/ply_rows.hpp"
#include "meet/io/text/cursor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace meetc::io {

namespace {

bool holds_row(const char *line, bool comments) {
  while (cursor::blank(*line))
    ++line;
  return *line != '\n' && !(comments && *line == '#');
}

// The rows of a piece. Most files have no line that begins with a blank or with '#', and then lines are rows.
std::size_t rows_in(std::string_view piece, bool comments) {
  constexpr std::size_t block = 128;
  std::size_t lines = 0, odd = static_cast<unsigned char>(piece.front()) <= '#';
  std::size_t i = 0;
  for (; i + block < piece.size(); i += block) {
    unsigned char n = 0, m = 0;
    for (std::size_t k = i; k < i + block; ++k) {
      const bool end = piece[k] == '\n';
      n = static_cast<unsigned char>(n + end);
      m = static_cast<unsigned char>(m + (end & (static_cast<unsigned char>(piece[k + 1]) <= '#')));
    }
    lines += n;
    odd += m;
  }
  for (; i < piece.size(); ++i) {
    lines += piece[i] == '\n';
    odd += piece[i] == '\n' && i + 1 < piece.size() && static_cast<unsigned char>(piece[i + 1]) <= '#';
  }
  if (odd == 0)
    return lines;
  std::size_t rows = 0;
  for (cursor c(piece); !c.done(); ++c.at) {
    rows += holds_row(c.at, comments);
    c.skip_line();
  }
  return rows;
}

class row_parser {
public:
  row_parser(const text_file &text, std::string_view piece, const ply_layout &layout, bool off, const misplaced *fault)
      : text_(text), c_(piece), layout_(layout), off_(off), fault_(fault) {}

  // The rows of a piece, of which the first has this number among those of all elements.
  mesh_part parse(std::size_t first_row) {
    for (const ply_element &e : layout_.header->elements) {
      if (e.properties.empty())
        continue;
      element_ = &e;
      if (first_row >= e.count) {
        first_row -= e.count;
        continue;
      }
      row_ = std::exchange(first_row, 0);
      for (; row_ < e.count && begin_row(); ++row_)
        row();
      if (row_ < e.count)
        break;
    }
    return std::move(part_);
  }

  // Parses all rows, after which nothing may follow.
  mesh_part parse_alone() {
    for (const ply_element &e : layout_.header->elements) {
      if (e.properties.empty()) // takes no bytes, whatever the count
        continue;
      element_ = &e;
      check_size();
      for (row_ = 0; row_ < e.count; ++row_) {
        if (!begin_row())
          text_.fail(last_line(),
                     fmt::format("the file ends after {} of {} rows of element {}", row_, e.count, quote(e.name)));
        row();
      }
    }
    if (begin_row())
      text_.fail(c_.at, fmt::format("{} after the last element", quote(c_.rest())));
    return std::move(part_);
  }

private:
  const char *last_line() const { return c_.end - 1; }
  [[noreturn]] void fail(std::string_view message) const {
    text_.fail(start_, fmt::format("{} {}: {}", element_->name, row_, message));
  }

  // This is enough to detect a false count: a row has a character and a line end, which the last line may lack.
  void check_size() const {
    constexpr std::size_t least = 2;
    const std::size_t left = text_.size_from(c_.at);
    if (element_->count > (left + 1) / least)
      text_.fail_in(text_.line_of(c_.at) - 1,
                    fmt::format("{} rows of element {} take at least {} bytes each, but {} bytes are left",
                                element_->count, quote(element_->name), least, left));
  }

  // To the next row. False at the end of the piece.
  bool begin_row() {
    while (!c_.done() && !holds_row(c_.at, off_)) {
      c_.skip_line();
      ++c_.at;
    }
    start_ = c_.at;
    return !c_.done();
  }

  void row() {
    if (element_ == layout_.vertex)
      vertex();
    else if (element_ == layout_.face)
      face();
    else
      for (const ply_property &p : element_->properties)
        pass_over(p);
    if (off_)
      pass_over_colour();
    c_.skip_blanks();
    if (!c_.at_line_end())
      fail(fmt::format("{} after the last value", quote(c_.rest())));
    ++c_.at;
  }

  void vertex() {
    float p[3];
    std::array<std::string_view, 3> words;
    bool finite = true;
    for (std::size_t k = 0; k < layout_.slots.size(); ++k) {
      if (layout_.slots[k] < 0) {
        pass_over(element_->properties[k]);
        continue;
      }
      const auto slot = static_cast<std::size_t>(layout_.slots[k]);
      if (!is_real(element_->properties[k].type)) { // the value must fit the integer type
        const char *const from = c_.at;
        integer(element_->properties[k].type);
        c_.at = from;
      }
      std::string_view unread;
      if (!c_.decimal(p[slot], part_.rounded, unread)) {
        if (unread.empty())
          fail("the line has too few values");
        fail(fmt::format("{} is not a number", quote(unread)));
      }
      words[slot] = unread;
      finite = finite && (unread.empty() || std::isfinite(p[slot]));
    }
    if (!finite)
      fail(describe_non_finite_point(p, words));
    if (fault_ && fault_->row == row_)
      fail(fault_->what);
    part_.xyz.insert(part_.xyz.end(), p, p + 3);
  }

  void face() {
    for (std::size_t k = 0; k < element_->properties.size(); ++k) {
      const ply_property &p = element_->properties[k];
      if (k != layout_.corners) {
        pass_over(p);
        continue;
      }
      const std::uint64_t n = list_count(p);
      if (n < 3)
        fail(fmt::format("{} corners; a face has at least 3", n));
      for (std::uint64_t i = 0; i < n; ++i) {
        const std::int64_t index = integer(p.type);
        if (index < 0 || static_cast<std::uint64_t>(index) >= layout_.vertices())
          fail(describe_missing_vertex(index, layout_.vertices()));
        part_.faces.vertices.push_back(static_cast<std::uint32_t>(index));
      }
      part_.faces.end_list(n);
    }
  }

  std::int64_t integer(ply_type type) {
    std::int64_t value = 0;
    std::string_view unread;
    if (!c_.integer(value, unread)) {
      if (unread.empty())
        fail("the line has too few values");
      fail(fmt::format("{} is not an integer", quote(unread)));
    }
    const unsigned bits = static_cast<unsigned>(8 * size_of(type));
    const bool is_signed = type == ply_type::int8 || type == ply_type::int16 || type == ply_type::int32;
    const std::int64_t most = (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
    if (value > most || value < (is_signed ? -most - 1 : 0)) {
      const char *from = c_.at;
      while (from > start_ && !cursor::space(from[-1]))
        --from;
      fail(fmt::format("{} does not fit the property's type", quote({from, static_cast<std::size_t>(c_.at - from)})));
    }
    return value;
  }

  std::uint64_t list_count(const ply_property &p) {
    const std::int64_t n = integer(p.count_type);
    if (n < 0)
      fail(fmt::format("the count of list {} is {}", quote(p.name), n));
    return static_cast<std::uint64_t>(n);
  }

  void pass_over(const ply_property &p) {
    for (std::uint64_t n = p.list ? list_count(p) : 1; n > 0; --n)
      if (c_.word().empty())
        fail("the line has too few values");
  }

  // The colour of an OFF's vertex has 3 or 4 numbers, that of a face any number; a comment may follow.
  void pass_over_colour() {
    std::size_t n = 0;
    for (c_.skip_blanks(); !c_.at_line_end() && *c_.at != '#'; ++n, c_.skip_blanks()) {
      float unused = 0;
      rounded_numbers ignored;
      std::string_view unread;
      if (!c_.decimal(unused, ignored, unread))
        fail(fmt::format("{} is not a number", quote(unread)));
    }
    if (element_ == layout_.vertex && n != 0 && n != 3 && n != 4)
      fail(fmt::format("{} numbers; x y z, and perhaps a colour of 3 or 4, were expected", n + 3));
    if (!c_.at_line_end())
      c_.skip_line();
  }

  const text_file &text_;
  cursor c_;
  const ply_layout &layout_;
  bool off_;
  const misplaced *fault_;
  const ply_element *element_ = nullptr;
  std::uint64_t row_ = 0;
  const char *start_ = nullptr; // of the row
  mesh_part part_;
};

} // namespace

mesh_part read_ply_ascii(const file_bytes &file, const ply_layout &layout, bool off, const read_request &q) {
  text_file text(file, q.by, layout.header->body_offset, layout.header->body_line);
  std::vector<std::string_view> pieces;
  if (!q.fault)
    pieces = text.pieces(at_any_line());
  std::vector<std::size_t> rows(pieces.size() + 1, 0);
  for_chunks(text.threads(), pieces.size(), 1,
             [&](int, std::size_t i, std::size_t) { rows[i + 1] = rows_in(pieces[i], off); });
  std::partial_sum(rows.begin(), rows.end(), rows.begin());
  std::uint64_t wanted = 0;
  for (const ply_element &e : layout.header->elements)
    wanted += e.properties.empty() || wanted > rows.back() ? 0 : e.count;
  if (rows.back() != wanted)
    pieces = {};
  std::vector<mesh_part> parts =
      parse_pieces<mesh_part>(text, pieces, [&](std::string_view piece, std::size_t i, bool alone) {
        row_parser rows_of_piece(text, piece, layout, off, q.fault);
        return alone ? rows_of_piece.parse_alone() : rows_of_piece.parse(rows[i]);
      });
  std::vector<mesh_part *> all;
  for (mesh_part &p : parts)
    all.push_back(&p);
  join_parts(all, q.by.threads);
  return std::move(parts.front());
}

} // namespace meetc::io
