#include "io/text/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace meetc::io {

namespace {

struct survey {
  bool nul = false, lone_return = false;
};

// Of the first n bytes, in blocks, so that a compiler makes vectors of it.
survey survey_of(std::string_view text, std::size_t n) {
  constexpr std::size_t block = 128;
  unsigned char nul = 0, lone = 0;
  std::size_t i = 0;
  for (; i + block < n; i += block) {
    unsigned char z = 0, r = 0;
    for (std::size_t k = i; k < i + block; ++k) {
      z = static_cast<unsigned char>(z | (text[k] == '\0'));
      r = static_cast<unsigned char>(r | ((text[k] == '\r') & (text[k + 1] != '\n')));
    }
    nul |= z;
    lone |= r;
  }
  for (; i < n; ++i) {
    nul |= text[i] == '\0';
    lone |= text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
  }
  return {nul != 0, lone != 0};
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
  text = without_end_mark(text);
  piece_ = by.piece_bytes ? by.piece_bytes
                          : std::clamp<std::size_t>(text.size() / (4 * static_cast<std::size_t>(by.threads)), 1 << 15,
                                                    std::size_t{1} << 19);
  std::atomic<bool> nul = false, lone = false;
  for_chunks(by.threads, text.size(), std::max<std::size_t>(piece_, 1 << 12),
             [&](int, std::size_t begin, std::size_t end) {
               const survey s = survey_of(text.substr(begin), end - begin);
               if (s.nul)
                 nul = true;
               if (s.lone_return)
                 lone = true;
             });
  nul_ = nul;
  if (lone) {
    copy_ = text;
    for (std::size_t i = 0; i < copy_.size(); ++i)
      if (copy_[i] == '\r' && (i + 1 == copy_.size() || copy_[i + 1] != '\n'))
        copy_[i] = '\n';
    text = copy_;
  }
  text_ = text;
  size_ = text.size();
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
