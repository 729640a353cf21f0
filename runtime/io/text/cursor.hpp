// A place in a piece of text (pieces.hpp), and the reading of words and numbers there, for every format. A line ends
// with LF; a CR before it is a blank. Slow paths read all words that are not plain numbers.
#ifndef MEETC_IO_TEXT_CURSOR_HPP
#define MEETC_IO_TEXT_CURSOR_HPP

#include "meet/io/text/decimal.hpp"
#include "meet/io/text/number.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace meetc::io {

struct cursor {
  const char *at, *end; // end[-1] is a line end

  explicit cursor(std::string_view piece) : at(piece.data()), end(piece.data() + piece.size()) {}

  bool done() const { return at >= end; }
  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool space(char c) { return blank(c) || c == '\n'; }

  void skip_blanks() {
    while (blank(*at))
      ++at;
  }
  bool at_line_end() const { return *at == '\n'; }
  // To the line end.
  void skip_line() { at = static_cast<const char *>(std::memchr(at, '\n', static_cast<std::size_t>(end - at))); }
  // The next word of the line; empty at its end.
  std::string_view word() {
    skip_blanks();
    const char *const from = at;
    while (!space(*at))
      ++at;
    return {from, static_cast<std::size_t>(at - from)};
  }
  // The rest of the line, without blanks at its ends; moves to the line end.
  std::string_view rest() {
    skip_blanks();
    const char *const from = at;
    skip_line();
    const char *to = at;
    while (to > from && blank(to[-1]))
      --to;
    return {from, static_cast<std::size_t>(to - from)};
  }

  // The decimal of the next word, rounded once to float32. False: there is none, and `unread` is the word.
  bool decimal(float &out, rounded_numbers &moved, std::string_view &unread) {
    skip_blanks();
    if (const char *const stop = read_decimal(at, out, moved); stop && space(*stop)) {
      at = stop;
      return true;
    }
    unread = word();
    return read_decimal_word(unread, out, moved);
  }

  // The integer of the next word. False: there is none, and `unread` is the word.
  bool integer(std::int64_t &out, std::string_view &unread) {
    skip_blanks();
    const bool negative = *at == '-';
    const char *p = at + negative;
    std::uint64_t n = 0;
    const char *const first = p;
    p = decimal_detail::digits(p, n);
    if (p > first && p - first < 19 && space(*p)) {
      out = negative ? -static_cast<std::int64_t>(n) : static_cast<std::int64_t>(n);
      at = p;
      return true;
    }
    unread = word();
    return parse_integer(unread, out);
  }
};

} // namespace meetc::io

#endif
