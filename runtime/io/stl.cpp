// STL: facets of three vertices, as rows of 9. Binary: any 80 bytes, a 32-bit count, then 50 bytes for each facet
// (normal, three vertices, two bytes), all little-endian. Ascii: solid … endsolid, perhaps several. Normals are neither
// used nor checked. A binary file may begin with "solid", so the size decides.
#include "io/endian.hpp"
#include "io/error.hpp"
#include "io/mesh_builder.hpp"
#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace meetc::io {

namespace {

constexpr std::size_t binary_header = 84, binary_facet = 50;

element_set finish(element_set &&set, const kind_info &triangle, const std::string &file) {
  set.kind = &triangle;
  set.elements = set.items = set.data.size() / 9;
  set.vertices = set.data.size() / 3;
  check_rules(set, file, "facet");
  return std::move(set);
}

element_set read_binary(const file_bytes &file, const kind_info &triangle, const transform &move) {
  const std::size_t count = load<std::uint32_t>(file.bytes.get() + 80, std::endian::little);
  element_set set;
  set.data.reserve(9 * count);
  for (std::size_t facet = 0; facet < count; ++facet) {
    const char *const corners = file.bytes.get() + binary_header + binary_facet * facet + 12;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> p{};
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = static_cast<double>(load<float>(corners + 12 * corner + 4 * c, std::endian::little));
      const std::array<float, 3> moved = move_point(move, p, [&](std::string_view what) {
        throw error(fmt::format("{}: facet {}: corner {}: {}", file.name, facet, corner, what));
      });
      set.data.insert(set.data.end(), moved.begin(), moved.end());
    }
  }
  return finish(std::move(set), triangle, file.name);
}

class ascii_reader {
public:
  ascii_reader(const file_bytes &file, const transform &move)
      : lines_(file.text(), file.name), move_(move), target_(move.any() ? precision::float64 : precision::float32) {}

  element_set read() {
    while (advance()) {
      if (lower_case(word_) != "solid")
        lines_.fail(fmt::format("{} where solid was expected", quote(word_)));
      line_ = {}; // the name
      while (facet())
        continue;
      line_ = {};
    }
    return std::move(set_);
  }

private:
  // Moves to the next word of the file, across line ends. Returns false at the end of the file.
  bool advance() {
    for (;;) {
      word_ = take_word(line_);
      if (!word_.empty())
        return true;
      if (!lines_.next(line_))
        return false;
    }
  }

  void need_word() {
    if (!advance())
      lines_.fail("the file ends before endsolid");
  }

  void expect(std::string_view keyword) {
    need_word();
    if (lower_case(word_) != keyword)
      lines_.fail(fmt::format("facet {}: {} where {} was expected", facets_, quote(word_), keyword));
  }

  bool facet() {
    need_word();
    const std::string keyword = lower_case(word_);
    if (keyword == "endsolid")
      return false;
    if (keyword != "facet")
      lines_.fail(fmt::format("{} where facet or endsolid was expected", quote(word_)));
    if (facets_ == most_elements)
      lines_.fail(fmt::format("more than {} facets", most_elements));
    expect("normal");
    for (int i = 0; i < 3; ++i)
      need_word();
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      vertex(corner);
    }
    expect("endloop");
    expect("endfacet");
    ++facets_;
    return true;
  }

  void vertex(int corner) {
    std::array<double, 3> p{};
    for (double &c : p) {
      need_word();
      if (!parse_decimal(word_, target_, c))
        lines_.fail(fmt::format("facet {}: corner {}: {} is not a number", facets_, corner, quote(word_)));
    }
    const std::array<float, 3> moved = move_point(move_, p, [&](std::string_view what) {
      lines_.fail(fmt::format("facet {}: corner {}: {}", facets_, corner, what));
    });
    set_.data.insert(set_.data.end(), moved.begin(), moved.end());
  }

  line_reader lines_;
  const transform &move_;
  precision target_;
  std::string_view line_, word_;
  std::size_t facets_ = 0;
  element_set set_;
};

} // namespace

element_set read_stl(const file_bytes &file, const kind_info &triangle, const transform &move) {
  if (file.size >= binary_header) {
    const std::size_t count = load<std::uint32_t>(file.bytes.get() + 80, std::endian::little);
    if (file.size == binary_header + binary_facet * count)
      return read_binary(file, triangle, move);
  }
  std::string_view start = file.text();
  if (start.starts_with("\xef\xbb\xbf"))
    start.remove_prefix(3);
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  const bool text = file.text().find('\0') == std::string_view::npos;
  if (text && lower_case(start.substr(0, 5)) == "solid")
    return finish(ascii_reader(file, move).read(), triangle, file.name);
  if (file.size < binary_header)
    throw error(fmt::format("{}: byte {}: neither ascii STL nor a whole header of binary STL ({} bytes)", file.name,
                            file.size, binary_header));
  const std::size_t count = load<std::uint32_t>(file.bytes.get() + 80, std::endian::little);
  throw error(fmt::format("{}: byte 80: the header says {} facets, which take {} bytes, but the file has {}", file.name,
                          count, binary_header + binary_facet * count, file.size));
}

} // namespace meetc::io
