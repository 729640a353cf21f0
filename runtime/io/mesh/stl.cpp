// STL: facets of three vertices, as rows of 9. Binary: any 80 bytes, a 32-bit count, then 50 bytes for each facet
// (normal, three vertices, two bytes), all little-endian. Ascii: solid … endsolid, perhaps several. Normals are neither
// used nor checked. A binary file may begin with "solid", so the size decides.
#include "meet/io/elements/readers.hpp"
#include "meet/io/files/endian.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/mesh.hpp"
#include "meet/io/mesh/stl_ascii.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace meetc::io {

namespace {

constexpr std::size_t binary_header = 84, binary_facet = 50;

[[noreturn]] void fail(const file_bytes &file, std::size_t facet, int field, std::string_view what) {
  throw error(fmt::format("{}: facet {}: corner {}: {}", file.name, facet, field / 3, what));
}

const char *corners_of(const file_bytes &file, std::size_t facet) {
  return file.bytes.get() + binary_header + binary_facet * facet + 12;
}

std::vector<float> read_binary(const file_bytes &file, std::size_t count, const read_request &q) {
  std::vector<float> rows(9 * count);
  std::atomic<bool> finite = true;
  for_chunks(q.by.threads, count, std::size_t{1} << 13, [&](int, std::size_t begin, std::size_t end) {
    float *out = &rows[9 * begin], sum = 0; // of 0 times each number, which is not 0 if one is not finite
    const char *from = corners_of(file, begin);
    for (std::size_t i = begin; i < end; ++i, from += binary_facet, out += 9)
      for (std::size_t k = 0; k < 9; ++k) {
        out[k] = load<float>(from + 4 * k, std::endian::little);
        sum += out[k] * 0;
      }
    if (!(sum == 0))
      finite = false;
  });
  for (std::size_t i = 0; !finite && i < rows.size(); ++i)
    if (!std::isfinite(rows[i]))
      fail(file, i / 9, static_cast<int>(i % 9),
           describe_non_finite(std::string_view("xyz").substr(i % 3, 1), static_cast<double>(rows[i]), rows[i]));
  if (q.fault)
    fail(file, q.fault->row, q.fault->field, q.fault->what);
  return rows;
}

element_set set_of_facets(const file_bytes &file, std::vector<float> &&rows, const read_request &q) {
  if (!q.kind.empty() && q.kind != "triangle")
    throw error(fmt::format("{}: --kind-{} {}: an STL file holds triangles", file.name, q.side, quote(q.kind)));
  element_set set;
  set.kind = &q.need(file.name, "triangle", 3, 9);
  if (rows.empty())
    throw error(fmt::format("{}: no facets to collide; it holds nothing", file.name));
  set.data = std::move(rows);
  set.elements = set.items = set.data.size() / 9;
  set.vertices = set.data.size() / 3;
  return set;
}

} // namespace

element_set read_stl(const file_bytes &file, const read_request &q) {
  const bool whole_header = file.size >= binary_header;
  const std::size_t count = whole_header ? load<std::uint32_t>(file.bytes.get() + 80, std::endian::little) : 0;
  const std::size_t wanted = binary_header + binary_facet * count;
  if (whole_header && file.size == wanted)
    return set_of_facets(file, read_binary(file, count, q), q);
  if (const bool text = file.text().find('\0') == std::string_view::npos; text) {
    stl_text found = read_stl_ascii(file, q);
    element_set set = set_of_facets(file, std::move(found.rows), q);
    set.rounded = found.rounded;
    return set;
  }
  if (!whole_header)
    throw error(fmt::format("{}: byte {}: neither ascii STL nor a whole header of binary STL ({} bytes)", file.name,
                            file.size, binary_header));
  // Surplus bytes that make whole facets mean that the count is wrong.
  if (count == 0 || file.size < wanted || (file.size - wanted) % binary_facet == 0)
    throw error(fmt::format("{}: byte 80: the header says {} facets, which take {} bytes, but the file has {}",
                            file.name, count, wanted, file.size));
  element_set set = set_of_facets(file, read_binary(file, count, q), q);
  set.notes.push_back(fmt::format("left out: {} bytes after the last facet", file.size - wanted));
  return set;
}

} // namespace meetc::io
