#include "meet/io/text/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace meetc::io {

namespace {

// Whether a byte is NUL, or a carriage return that no line feed follows; in blocks, so that a compiler makes vectors of it.
// The last byte is a line end.
bool is_odd(std::string_view text) {
  constexpr std::size_t block = 128;
  unsigned char odd = 0;
  std::size_t i = 0;
  for (; i + block < text.size() && !odd; i += block)
    for (std::size_t k = i; k < i + block; ++k)
      odd = static_cast<unsigned char>(odd | (text[k] == '\0') | ((text[k] == '\r') & (text[k + 1] != '\n')));
  for (; i + 1 < text.size() && !odd; ++i)
    odd = text[i] == '\0' || (text[i] == '\r' && text[i + 1] != '\n');
  return odd != 0;
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// The text without a control character at its very end; line ends may follow a Ctrl-Z alone.
std::string_view without_end_mark(std::string_view text) {
  std::size_t n = text.size();
  while (n > 0 && is_space(text[n - 1]))
    --n;
  const unsigned char last = n > 0 ? static_cast<unsigned char>(text[n - 1]) : 0;
  const bool mark = last == 0x1a || (n == text.size() && ((last > 0 && last < 0x20) || last == 0x7f));
  return mark ? text.substr(0, n - 1) : text;
}

} // namespace

text_file::text_file(const file_bytes &file, const work &by, std::size_t offset, std::size_t first_line)
    : name_(file.name), by_(by), first_line_(first_line) {
  std::string_view text = file.text().substr(offset);
  if (offset == 0 && text.starts_with("\xef\xbb\xbf"))
    text.remove_prefix(3);
  text_ = without_end_mark(text);
  size_ = text_.size();
  piece_ = by.piece_bytes
               ? by.piece_bytes
               : std::clamp<std::size_t>(size_ / (8 * static_cast<std::size_t>(by.threads)), 1 << 15, 1 << 17);
}

void text_file::check_piece(std::string_view piece) const {
  if (is_odd(piece))
    throw error("");
}

std::string_view text_file::keep_tail(std::size_t from) {
  tail_ = text_.substr(from);
  if (tail_.back() != '\n')
    tail_ += '\n';
  const std::size_t size = tail_.size();
  tail_.append(text_slack, '\0');
  text_ = text_.substr(0, from);
  return std::string_view(tail_).substr(0, size);
}

std::string_view text_file::whole() const {
  if (whole_.empty()) {
    whole_.reserve(text_.size() + tail_.size() + text_slack + 1);
    whole_ = text_;
    whole_.append(tail_, 0, tail_.size() - std::min(tail_.size(), text_slack));
    if (!whole_.empty() && whole_.back() != '\n')
      whole_ += '\n';
    for (std::size_t i = 0; i < whole_.size(); ++i)
      if (whole_[i] == '\r' && whole_[i + 1] != '\n')
        whole_[i] = '\n';
    whole_.append(text_slack, '\0');
  }
  return std::string_view(whole_).substr(0, whole_.size() - text_slack);
}

std::size_t text_file::line_of(const char *at) const {
  const auto lines = [at](std::string_view text) {
    const bool inside = std::greater_equal<>()(at, text.data()) && std::less_equal<>()(at, text.data() + text.size());
    return inside ? std::count(text.data(), at, '\n') : -1;
  };
  std::ptrdiff_t before = lines(whole_);
  if (before < 0)
    before = lines(text_);
  if (before < 0)
    before = std::count(text_.begin(), text_.end(), '\n') + lines(tail_);
  return first_line_ + static_cast<std::size_t>(before);
}

void text_file::fail_in(std::size_t line, std::string_view message) const {
  throw error(fmt::format("{}:{}: {}", name_, line, message));
}

} // namespace meetc::io
