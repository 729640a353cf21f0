#include "gen/columns.hpp"

#include <algorithm>
#include <array>

namespace meetc {
namespace {

struct range {
  char32_t first, last;
};
// Marks that stand on the character before them, and wide characters (Unicode's East Asian Width W and F, in blocks).
constexpr std::array marks{range{0x300, 0x36f},   range{0x483, 0x489},   range{0x591, 0x5bd},   range{0x64b, 0x65f},
                           range{0x1ab0, 0x1aff}, range{0x1dc0, 0x1dff}, range{0x200b, 0x200f}, range{0x20d0, 0x20ff},
                           range{0xfe00, 0xfe0f}, range{0xfe20, 0xfe2f}};
constexpr std::array wide{range{0x1100, 0x115f},   range{0x2e80, 0x303e},  range{0x3041, 0xa4cf},
                          range{0xac00, 0xd7a3},   range{0xf900, 0xfaff},  range{0xfe30, 0xfe6f},
                          range{0xff00, 0xff60},   range{0xffe0, 0xffe6},  range{0x1f300, 0x1f64f},
                          range{0x1f900, 0x1f9ff}, range{0x20000, 0x3fffd}};

template <std::size_t n> bool is_in(const std::array<range, n> &all, char32_t c) {
  return std::any_of(all.begin(), all.end(), [c](const range &r) { return c >= r.first && c <= r.last; });
}

} // namespace

std::size_t displayed_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    char32_t c = lead < 0xc0 ? lead : lead < 0xe0 ? lead & 0x1f : lead < 0xf0 ? lead & 0xf : lead & 7;
    for (; lead >= 0xc0 && i < text.size() && (text[i] & 0xc0) == 0x80; ++i)
      c = c << 6 | (text[i] & 0x3f);
    width += is_in(marks, c) ? 0 : is_in(wide, c) ? 2 : 1;
  }
  return width;
}

std::string in_columns(const std::vector<std::vector<std::string>> &rows, bool words_last) {
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto &row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], displayed_width(row[i]));
  std::string out;
  for (const auto &row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - displayed_width(row[i]), ' ');
      out += i == 0 ? row[i] + padding : words_last && i + 1 == row.size() ? "  " + row[i] : "  " + padding + row[i];
    }
    out += '\n';
  }
  return out;
}

} // namespace meetc
