#include "meet/io/text/text.hpp"

#include "meet/io/files/error.hpp"

#include <fmt/format.h>

namespace meetc::io {

namespace {
constexpr bool blank(char c) {
  return c == ' ' || c == '\t';
}
} // namespace

std::string_view trim(std::string_view text) {
  while (!text.empty() && blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && blank(text.back()))
    text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view &line) {
  std::size_t begin = 0;
  while (begin < line.size() && blank(line[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < line.size() && !blank(line[end]))
    ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char &c : out)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return out;
}

line_reader::line_reader(std::string_view text, std::string name, std::size_t offset, std::size_t first_line)
    : text_(text), name_(std::move(name)), at_(offset), number_(first_line - 1) {
  if (at_ == 0 && text_.starts_with("\xef\xbb\xbf"))
    at_ = 3;
}

bool line_reader::next(std::string_view &line) {
  if (at_ >= text_.size())
    return false;
  ++number_;
  const std::size_t found = text_.find_first_of("\r\n", at_);
  const std::size_t end = found == std::string_view::npos ? text_.size() : found;
  line = text_.substr(at_, end - at_);
  at_ = end + (found == std::string_view::npos ? 0 : text_.substr(found, 2) == "\r\n" ? 2 : 1);
  return true;
}

void line_reader::fail(std::string_view message) const {
  throw error(fmt::format("{}:{}: {}", name_, number_ == 0 ? 1 : number_, message));
}

} // namespace meetc::io
