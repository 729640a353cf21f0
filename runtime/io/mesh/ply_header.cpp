#include "meet/io/mesh/ply_header.hpp"

#include "meet/io/files/error.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace meetc::io {

namespace {

std::optional<ply_type> type_of(std::string_view name) {
  constexpr std::pair<std::string_view, ply_type> names[] = {
      {"char", ply_type::int8},      {"int8", ply_type::int8},       {"uchar", ply_type::uint8},
      {"uint8", ply_type::uint8},    {"short", ply_type::int16},     {"int16", ply_type::int16},
      {"ushort", ply_type::uint16},  {"uint16", ply_type::uint16},   {"int", ply_type::int32},
      {"int32", ply_type::int32},    {"uint", ply_type::uint32},     {"uint32", ply_type::uint32},
      {"float", ply_type::float32},  {"float32", ply_type::float32}, {"double", ply_type::float64},
      {"float64", ply_type::float64}};
  for (const auto &[known, type] : names)
    if (known == name)
      return type;
  return std::nullopt;
}

class header_reader {
public:
  explicit header_reader(const file_bytes &file) : lines_(file.text(), file.name) {}

  ply_header read() {
    std::string_view line;
    if (!lines_.next(line) || line != "ply")
      lines_.fail(fmt::format("the first line is {}, not 'ply'", quote(line)));
    while (lines_.next(line)) {
      const std::string_view key = take_word(line);
      if (key == "end_header") {
        end_statement(line);
        if (!format_)
          lines_.fail("the header has no format line");
        out_.format = *format_;
        out_.body_offset = lines_.offset();
        out_.body_line = lines_.number() + 1;
        return std::move(out_);
      }
      statement(key, line);
    }
    lines_.fail("the header has no end_header");
  }

private:
  void statement(std::string_view key, std::string_view line) {
    if (key == "format")
      format(line);
    else if (key == "element")
      element(line);
    else if (key == "property")
      property(line);
    else if (key != "comment" && key != "obj_info")
      lines_.fail(fmt::format("unknown header line {}", quote(key)));
  }

  std::string_view need(std::string_view &line, std::string_view what) {
    const std::string_view word = take_word(line);
    if (word.empty())
      lines_.fail(fmt::format("{} is missing", what));
    return word;
  }

  void end_statement(std::string_view line) const {
    if (const std::string_view rest = trim(line); !rest.empty())
      lines_.fail(fmt::format("{} after the end of the header line", quote(rest)));
  }

  void format(std::string_view line) {
    const std::string_view name = need(line, "the format"), version = need(line, "the format's version");
    end_statement(line);
    if (format_)
      lines_.fail("a second format line");
    if (name == "ascii")
      format_ = ply_format::ascii;
    else if (name == "binary_little_endian")
      format_ = ply_format::little_endian;
    else if (name == "binary_big_endian")
      format_ = ply_format::big_endian;
    else
      lines_.fail(
          fmt::format("unknown format {}; supported: ascii, binary_little_endian, binary_big_endian", quote(name)));
    if (version != "1.0")
      lines_.fail(fmt::format("unknown version {}; supported: 1.0", quote(version)));
  }

  void element(std::string_view line) {
    ply_element e;
    e.name = need(line, "the element's name");
    const std::string_view count = need(line, "the element's count");
    end_statement(line);
    std::int64_t n = 0;
    if (!parse_integer(count, n) || n < 0)
      lines_.fail(fmt::format("the count of element {} is {}, not a count", quote(e.name), quote(count)));
    e.count = static_cast<std::uint64_t>(n);
    const bool special = e.name == "vertex" || e.name == "face";
    if (special && std::ranges::find(out_.elements, e.name, &ply_element::name) != out_.elements.end())
      lines_.fail(fmt::format("a second element {}", e.name));
    if (e.name == "tristrips" && n > 0)
      lines_.fail("triangle strips (element tristrips) are not supported; save the mesh with faces");
    out_.elements.push_back(std::move(e));
  }

  ply_type need_type(std::string_view &line, std::string_view what) {
    const std::string_view name = need(line, what);
    const std::optional<ply_type> type = type_of(name);
    if (!type)
      lines_.fail(fmt::format("unknown type {}", quote(name)));
    return *type;
  }

  void property(std::string_view line) {
    if (out_.elements.empty())
      lines_.fail("a property before the first element");
    ply_property p{};
    std::string_view ahead = line;
    if (take_word(ahead) == "list") {
      line = ahead;
      p.list = true;
      p.count_type = need_type(line, "the list's count type");
      if (is_real(p.count_type))
        lines_.fail("the count type of a list must be an integer type");
    }
    p.type = need_type(line, "the property's type");
    p.name = need(line, "the property's name");
    end_statement(line);
    out_.elements.back().properties.push_back(std::move(p));
  }

  line_reader lines_;
  ply_header out_;
  std::optional<ply_format> format_;
};

} // namespace

ply_header read_ply_header(const file_bytes &file) {
  return header_reader(file).read();
}

} // namespace meetc::io
