#include "meet/io/mesh/stl_ascii.hpp"

#include "meet/io/mesh/mesh.hpp"

#include "meet/io/files/error.hpp"
#include "meet/io/text/cursor.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace meetc::io {

namespace {

struct facet_part : stl_text {
  bool solid_at_end = false; // whether a solid is open
};

bool is_word(const char *at, std::string_view keyword) {
  for (const char k : keyword)
    if ((*at++ | 0x20) != k)
      return false;
  return cursor::space(*at);
}

class facet_parser {
public:
  facet_parser(const text_file &text, std::string_view piece, const misplaced *fault)
      : text_(text), c_(piece), fault_(fault) {}

  // A piece that is not the first starts inside a solid.
  facet_part parse(bool in_solid) {
    for (;;) {
      if (!in_solid) {
        if (!skip())
          return std::move(part_);
        if (!is_word(c_.at, "solid"))
          text_.fail(c_.at, fmt::format("{} where solid was expected", quote(word())));
        c_.at += 5;
        skip_name();
      }
      in_solid = false;
      while (facet())
        continue;
      if (part_.solid_at_end)
        return std::move(part_);
    }
  }

private:
  std::size_t facets() const { return part_.rows.size() / 9; }
  std::string_view word() { return c_.word(); }

  // To the next word, over line ends and comments. False at the end of the piece.
  bool skip() {
    for (; !c_.done(); ++c_.at) {
      if (*c_.at == '#' || *c_.at == ';')
        c_.skip_line();
      else if (!cursor::space(*c_.at))
        return true;
    }
    return false;
  }
  void need_word() {
    if (!skip())
      text_.fail(c_.end - 1, "the file ends before endsolid");
  }

  void expect(std::string_view keyword) {
    need_word();
    if (!is_word(c_.at, keyword)) {
      const char *const from = c_.at;
      text_.fail(from, fmt::format("facet {}: {} where {} was expected", facets(), quote(word()), keyword));
    }
    c_.at += keyword.size();
  }

  // A name goes to the end of its line, unless the line holds a facet too, as where the whole file is one line. After
  // endsolid the next solid may follow.
  void skip_name() {
    const char *const from = c_.at;
    c_.skip_line();
    const char *const stop = c_.at;
    c_.at = from;
    const char *solid = nullptr;
    while (c_.at < stop) {
      c_.skip_blanks();
      const char *const at = c_.at;
      if (is_word(at, "solid"))
        solid = at;
      if (is_word(at, "facet")) {
        c_.at = at + 5;
        c_.skip_blanks();
        if (is_word(c_.at, "normal") || is_word(c_.at, "outer")) {
          c_.at = after_end_ && solid ? solid : at;
          return;
        }
        c_.at = at;
      }
      word();
    }
  }

  // Reads a facet. False at endsolid, and at the end of a piece inside a solid.
  bool facet() {
    if (!skip()) {
      part_.solid_at_end = true;
      return false;
    }
    if (is_word(c_.at, "endsolid")) {
      c_.at += 8;
      after_end_ = true;
      skip_name();
      after_end_ = false;
      return false;
    }
    if (!is_word(c_.at, "facet")) {
      const char *const from = c_.at;
      text_.fail(from, fmt::format("{} where facet or endsolid was expected", quote(word())));
    }
    c_.at += 5;
    if (facets() == most_elements)
      text_.fail(c_.at, fmt::format("more than {} facets", most_elements));
    need_word();
    if (is_word(c_.at, "normal")) {
      c_.at += 6;
      for (int i = 0; i < 3; ++i) {
        need_word();
        if (is_word(c_.at, "outer"))
          break;
        word();
      }
    } else if (!is_word(c_.at, "outer")) {
      expect("normal");
    }
    expect("outer");
    expect("loop");
    float row[9];
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      vertex(corner, row + 3 * corner);
    }
    expect("endloop");
    expect("endfacet");
    part_.rows.insert(part_.rows.end(), row, row + 9);
    return true;
  }

  void vertex(int corner, float *p) {
    std::array<std::string_view, 3> words;
    bool finite = true;
    const char *from = nullptr;
    for (std::size_t k = 0; k < 3; ++k) {
      need_word();
      from = c_.at;
      if (!c_.decimal(p[k], part_.rounded, words[k]))
        fail(from, corner, fmt::format("{} is not a number", quote(words[k])));
      finite = finite && (words[k].empty() || std::isfinite(p[k]));
    }
    if (!finite)
      fail(from, corner, describe_non_finite_point(p, words));
    if (fault_ && fault_->row == facets() && fault_->field / 3 == corner)
      fail(from, corner, fault_->what);
  }
  [[noreturn]] void fail(const char *at, int corner, std::string_view what) const {
    text_.fail(at, fmt::format("facet {}: corner {}: {}", facets(), corner, what));
  }

  const text_file &text_;
  cursor c_;
  const misplaced *fault_;
  bool after_end_ = false;
  facet_part part_;
};

// A line that begins with "facet" is inside a solid, and begins a facet.
struct before_facet {
  bool operator()(std::string_view line, std::string_view) const {
    const std::size_t word = line.find_first_not_of(" \t\r\n");
    return word != std::string_view::npos && line.size() - word > 6 && is_word(line.data() + word, "facet");
  }
};

} // namespace

stl_text read_stl_ascii(const file_bytes &file, const read_request &q) {
  text_file text(file, q.by);
  const auto parse = [&](std::string_view piece, std::size_t i, bool alone) {
    facet_part part = facet_parser(text, piece, q.fault).parse(i > 0);
    if (alone && part.solid_at_end)
      text.fail(text.whole().data() + text.whole().size() - 1, "the file ends before endsolid");
    return part;
  };
  std::vector<facet_part> parts;
  if (!q.fault)
    parts = parse_pieces<facet_part>(text, text.pieces(before_facet()), parse);
  // Every piece but the last ends between two facets of a solid.
  bool whole = q.fault != nullptr;
  for (std::size_t i = 0; i < parts.size(); ++i)
    whole = whole || parts[i].solid_at_end != (i + 1 < parts.size());
  if (whole)
    parts = parse_pieces<facet_part>(text, {}, parse);
  mesh_part rows = join_rows(parts, q.by.threads);
  return {std::move(rows.xyz), rows.rounded};
}

} // namespace meetc::io
