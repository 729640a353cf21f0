// PLY: the vertices and faces among everything that the header announces. Elements and properties may come in any
// order; those that are not needed are skipped. It is written by hand, so that a count is checked against the size of
// the file before it is trusted, and each error names its row. OFF has the same body after a header of its own.
#include "meet/core/views/nouns.hpp"
#include "meet/io/elements/readers.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/ply_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace meetc::io {

namespace {

bool is_corner_list(std::string_view name) {
  return name == "vertex_indices" || name == "vertex_index";
}

std::vector<int> coordinate_slots(const ply_element &vertex, const std::string &file) {
  std::vector<int> slots(vertex.properties.size(), -1);
  for (int c = 0; c < 3; ++c) {
    const std::string_view name = std::string_view("xyz").substr(static_cast<std::size_t>(c), 1);
    const auto found = std::ranges::find(vertex.properties, name, &ply_property::name);
    if (found == vertex.properties.end())
      throw error(fmt::format("{}: element vertex has no property {}", file, name));
    if (found->list)
      throw error(fmt::format("{}: property {} of element vertex is a list", file, name));
    if (std::ranges::count(vertex.properties, name, &ply_property::name) > 1)
      throw error(fmt::format("{}: element vertex has property {} twice", file, name));
    slots[static_cast<std::size_t>(found - vertex.properties.begin())] = c;
  }
  return slots;
}

// The index of the face's list of corners among its properties.
std::size_t corner_list(const ply_element &face, const std::string &file) {
  const auto named = [](const ply_property &p) { return is_corner_list(p.name); };
  const auto found = std::ranges::find_if(face.properties, named);
  if (found == face.properties.end())
    throw error(fmt::format("{}: element face has no property vertex_indices or vertex_index", file));
  if (std::ranges::count_if(face.properties, named) > 1)
    throw error(fmt::format("{}: element face has two lists of vertex indices", file));
  if (!found->list || is_real(found->type))
    throw error(fmt::format("{}: property {} of element face is not a list of integers", file, found->name));
  return static_cast<std::size_t>(found - face.properties.begin());
}

} // namespace

std::string describe_missing_vertex(std::int64_t index, std::size_t vertices) {
  return fmt::format("vertex {} does not exist; the file has {}, counted from 0", index, vertices);
}

ply_layout layout_of(const std::string &file, const ply_header &header) {
  ply_layout out;
  out.file = file;
  out.header = &header;
  const auto find = [&](std::string_view name) -> const ply_element * {
    const auto found = std::ranges::find(header.elements, name, &ply_element::name);
    return found == header.elements.end() ? nullptr : &*found;
  };
  out.vertex = find("vertex");
  if (!out.vertex)
    throw error(fmt::format("{}: the header has no element vertex; a mesh has vertices and faces", file));
  out.slots = coordinate_slots(*out.vertex, file);
  out.face = find("face");
  if (out.face && out.face->count == 0)
    out.face = nullptr;
  if (out.face)
    out.corners = corner_list(*out.face, file);
  if (out.vertices() > most_elements)
    throw error(fmt::format("{}: {} vertices; at most {} can be indexed", file, out.vertices(), most_elements));
  return out;
}

element_set read_ply(const file_bytes &file, const read_request &q) {
  const ply_header header = read_ply_header(file);
  const ply_layout layout = layout_of(file.name, header);
  mesh_part all =
      header.format == ply_format::ascii ? read_ply_ascii(file, layout, false, q) : read_ply_binary(file, layout, q);
  std::vector<std::string> notes;
  for (const ply_element &e : header.elements)
    if (e.name == "edge" && e.count > 0)
      notes.push_back(fmt::format("left out: {} {}", e.count, e.count == 1 ? e.name : plural_of(e.name)));
  return set_of(file.name, std::move(all), true, notes, q);
}

} // namespace meetc::io
