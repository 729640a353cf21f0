// OFF and COFF in ascii, as Geomview defines them: a keyword, the numbers of vertices, faces and edges, a line for each
// vertex and a line for each face, which begins with its number of corners. Colours are passed over; comments begin with '#'.
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/ply_rows.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace meetc::io {

namespace {

// The next line that is not blank, without its comment. False at the end of the file.
bool next_line(line_reader &lines, std::string_view &line) {
  while (lines.next(line)) {
    line = trim(line.substr(0, line.find('#')));
    if (!line.empty())
      return true;
  }
  return false;
}

std::uint64_t take_count(const line_reader &lines, std::string_view &line, std::string_view of) {
  const std::string_view word = take_word(line);
  std::int64_t n = 0;
  if (!parse_integer(word, n) || n < 0)
    lines.fail(fmt::format("the number of {} is {}, not a count", of, quote(word)));
  return static_cast<std::uint64_t>(n);
}

} // namespace

element_set read_off(const file_bytes &file, const read_request &q) {
  line_reader lines(file.text(), file.name);
  std::string_view line;
  if (!next_line(lines, line))
    lines.fail("an OFF file begins with OFF or COFF");
  const std::string_view keyword = take_word(line);
  std::string_view ahead = line;
  const bool binary = lower_case(take_word(ahead)) == "binary";
  if (binary || (keyword != "OFF" && keyword != "COFF")) {
    if (keyword.ends_with("OFF"))
      lines.fail(fmt::format("{}: this kind of OFF is not supported; OFF and COFF in ascii are",
                             quote(std::string(keyword) + (binary ? " BINARY" : ""))));
    lines.fail(fmt::format("the first word is {}, not OFF or COFF", quote(keyword)));
  }
  if (trim(line).empty() && !next_line(lines, line))
    lines.fail("the file ends before the numbers of vertices and faces");
  const std::uint64_t vertices = take_count(lines, line, "vertices"), faces = take_count(lines, line, "faces");
  if (!trim(line).empty())
    take_count(lines, line, "edges"); // the file does not list them
  if (const std::string_view rest = trim(line); !rest.empty())
    lines.fail(fmt::format("{} after the numbers of vertices, faces and edges", quote(rest)));
  ply_header header;
  ply_element vertex{"vertex", vertices, {}}, face{"face", faces, {}};
  for (const char *const axis : {"x", "y", "z"})
    vertex.properties.push_back({axis, ply_type::float32, false, {}});
  face.properties.push_back({"vertex_index", ply_type::int32, true, ply_type::int32});
  header.elements = {std::move(vertex), std::move(face)};
  header.body_offset = lines.offset();
  header.body_line = lines.number() + 1;
  const ply_layout layout = layout_of(file.name, header);
  return set_of(file.name, read_ply_ascii(file, layout, true, q), true, {}, q);
}

} // namespace meetc::io
