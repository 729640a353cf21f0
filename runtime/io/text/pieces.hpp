// A text file cut into pieces at line ends, which several threads parse.
//
// Each piece ends with a line end and is followed by text_slack readable bytes, so that scanning needs no bounds. A
// piece knows neither its line nor how many elements precede it. If a piece has a fault, the whole text is parsed again
// as one piece, which names the place; a result and a message are thus the same for any number of threads and pieces.
#ifndef MEETC_IO_TEXT_PIECES_HPP
#define MEETC_IO_TEXT_PIECES_HPP

#include "meet/core/threads/threads.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/files/file_bytes.hpp"
#include "meet/io/text/decimal.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::io {

// The division of a file's parsing among threads.
struct work {
  int threads = 1;
  std::size_t piece_bytes = 0; // 0: chosen by the size of the text
};

class text_file {
public:
  // The text from byte `offset` on, which is in line `first_line`. A byte order mark is left out, and so is a control
  // character (not NUL) at the very end, with which old systems end a file. A carriage return alone ends a line.
  text_file(const file_bytes &file, const work &by, std::size_t offset = 0, std::size_t first_line = 1);
  text_file(const text_file &) = delete;
  text_file &operator=(const text_file &) = delete;

  // In order; none is empty. starts(line, before) says whether a piece may start with the line that begins there, after
  // the text `before`, which ends with a line end. Empty: the text makes one piece. Called once.
  template <class Starts> std::vector<std::string_view> pieces(const Starts &starts) {
    std::vector<std::string_view> out;
    // The last lines are copied, so that they have an end and slack.
    const auto start_before = [&](std::size_t at) {
      do
        at = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
      while (at != std::string_view::npos && !starts(text_.substr(at + 1), text_.substr(0, at + 1)));
      return at == std::string_view::npos ? 0 : at + 1;
    };
    const std::size_t body = start_before(text_.size() - std::min(text_.size(), text_slack));
    if (body == 0 || text_.size() <= piece_)
      return out;
    for (std::size_t begin = 0; begin < body;) {
      std::size_t end = begin + piece_ < body ? text_.find('\n', begin + piece_ - 1) + 1 : body;
      while (end < body && !starts(text_.substr(end), text_.substr(0, end)))
        end = text_.find('\n', end) + 1;
      out.push_back(text_.substr(begin, end - begin));
      begin = end;
    }
    out.push_back(keep_tail(body));
    return out;
  }

  // The text as one piece.
  std::string_view whole() const;

  int threads() const { return by_.threads; }
  // Throws io::error, whose message nobody reads, if a piece holds a byte that a parser must not see: a carriage return
  // alone, or a NUL.
  void check_piece(std::string_view piece) const;
  // The line of a byte of a piece, or of whole().
  std::size_t line_of(const char *at) const;
  // The number of bytes of the file from a place in whole() on.
  std::size_t size_from(const char *at) const {
    return size_ - std::min(size_, static_cast<std::size_t>(at - whole_.data()));
  }
  // Throws io::error `FILE:LINE: message`.
  [[noreturn]] void fail(const char *at, std::string_view message) const { fail_in(line_of(at), message); }
  [[noreturn]] void fail_in(std::size_t line, std::string_view message) const;

private:
  std::string_view keep_tail(std::size_t from);

  std::string name_;
  work by_;
  std::size_t piece_ = 0, first_line_ = 1, size_ = 0;
  std::string_view text_;
  std::string tail_; // with a line end and slack
  mutable std::string whole_;
};

// Whether a piece may start at any line.
struct at_any_line {
  bool operator()(std::string_view, std::string_view) const { return true; }
};

// The results of parse(piece, i, alone) for each piece i, on several threads. If one throws io::error, the result of
// parsing the whole text as one piece (alone), which may throw it with its place.
template <class Part, class Parse>
std::vector<Part> parse_pieces(const text_file &text, const std::vector<std::string_view> &pieces, const Parse &parse) {
  if (pieces.size() > 1) {
    std::vector<Part> parts(pieces.size());
    try {
      for_chunks(text.threads(), pieces.size(), 1, [&](int, std::size_t i, std::size_t) {
        text.check_piece(pieces[i]);
        parts[i] = parse(pieces[i], i, false);
      });
      return parts;
    } catch (const error &) {
    }
  }
  std::vector<Part> one;
  one.push_back(parse(text.whole(), 0, true));
  return one;
}

} // namespace meetc::io

#endif
