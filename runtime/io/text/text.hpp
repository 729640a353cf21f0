// Lines and words of a text file, with the line number for messages.
#ifndef MEETC_IO_TEXT_TEXT_HPP
#define MEETC_IO_TEXT_TEXT_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace meetc::io {

// Removes blanks (spaces, tabs) from both ends.
std::string_view trim(std::string_view text);

// Takes the next word from the front of `line`; empty at its end.
std::string_view take_word(std::string_view &line);

// Turns A to Z into lower case in every locale.
std::string lower_case(std::string_view text);

// Reads a text line by line. LF, CRLF or CR ends a line, and the last one may lack it. A UTF-8 byte order mark is skipped.
class line_reader {
public:
  // `first_line` and `offset` say where the text starts, for a text that follows a header.
  line_reader(std::string_view text, std::string name, std::size_t offset = 0, std::size_t first_line = 1);

  // Returns false at the end. The line comes without its line end.
  bool next(std::string_view &line);
  std::size_t number() const { return number_; } // of the line that next() returned last
  std::size_t offset() const { return at_; }     // of the byte after that line
  // Throws io::error `FILE:LINE: message`.
  [[noreturn]] void fail(std::string_view message) const;

private:
  std::string_view text_;
  std::string name_;
  std::size_t at_, number_;
};

} // namespace meetc::io

#endif
