// PLY: the vertices and faces among everything that the header announces. Elements and properties may come in any
// order; those that are not needed are skipped. It is written by hand, so that a count is checked against the size of
// the file before it is trusted, and each error names its row.
#include "io/error.hpp"
#include "io/mesh_builder.hpp"
#include "io/ply_sources.hpp"
#include "io/readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace meetc::io {

namespace {

bool is_corner_list(std::string_view name) {
  return name == "vertex_indices" || name == "vertex_index";
}

const ply_element &find_element(const ply_header &header, std::string_view name, const std::string &file) {
  const auto found = std::ranges::find(header.elements, name, &ply_element::name);
  if (found == header.elements.end())
    throw error(fmt::format("{}: the header has no element {}; a mesh has vertices and faces", file, name));
  return *found;
}

// Says for each property of a vertex which coordinate it is: 0, 1, 2, or -1 for one to skip.
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

template <class Source> class body_reader {
public:
  body_reader(const file_bytes &file, const ply_header &header, const kind_info &triangle, const transform &move)
      : file_(file), header_(header), source_(file, header, move.any() ? precision::float64 : precision::float32),
        mesh_(triangle, move) {}

  element_set read() {
    const ply_element &vertex = find_element(header_, "vertex", file_.name);
    const ply_element &face = find_element(header_, "face", file_.name);
    const std::vector<int> slots = coordinate_slots(vertex, file_.name);
    const std::size_t corners = face.count == 0 ? 0 : corner_list(face, file_.name);
    // Faces may come first, so their corners are checked against the header's count. That count has been verified by
    // the time the set is returned.
    vertices_ = vertex.count;
    if (vertices_ > most_elements)
      throw error(fmt::format("{}: {} vertices; at most {} can be indexed", file_.name, vertices_, most_elements));
    for (const ply_element &e : header_.elements) {
      // Rows without properties take no bytes, whatever their number.
      if (e.properties.empty())
        continue;
      source_.begin(e);
      if (&e == &vertex)
        read_vertices(e, slots);
      else if (&e == &face && e.count > 0)
        read_faces(e, corners);
      else
        pass_over(e);
    }
    source_.end();
    return mesh_.finish(file_.name);
  }

private:
  std::uint64_t list_count(const ply_property &p) {
    const std::int64_t n = source_.integer(p.count_type);
    if (n < 0)
      source_.fail(fmt::format("the count of list {} is {}", quote(p.name), n));
    return static_cast<std::uint64_t>(n);
  }

  void pass_over(const ply_property &p) { source_.skip(p.type, p.list ? list_count(p) : 1); }

  void pass_over(const ply_element &e) {
    for (std::uint64_t i = 0; i < e.count; ++i) {
      source_.begin_row();
      for (const ply_property &p : e.properties)
        pass_over(p);
      source_.end_row();
    }
  }

  void read_vertices(const ply_element &e, const std::vector<int> &slots) {
    mesh_.reserve(e.count, 0);
    for (std::uint64_t i = 0; i < e.count; ++i) {
      source_.begin_row();
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < slots.size(); ++k) {
        if (slots[k] < 0)
          pass_over(e.properties[k]);
        else
          p[static_cast<std::size_t>(slots[k])] = source_.real(e.properties[k].type);
      }
      mesh_.add_vertex(p, [&](std::string_view what) { source_.fail(what); });
      source_.end_row();
    }
  }

  void read_faces(const ply_element &e, std::size_t corners) {
    const ply_property &list = e.properties[corners];
    // The capacity is limited to what the file could hold as triangles, whatever the count says.
    const std::size_t row = size_of(list.count_type) + 3 * size_of(list.type);
    const std::size_t least = header_.format == ply_format::ascii ? 8 : row;
    mesh_.reserve(0, std::min<std::size_t>(e.count, file_.size / least));
    for (std::uint64_t i = 0; i < e.count; ++i) {
      source_.begin_row();
      for (std::size_t k = 0; k < e.properties.size(); ++k) {
        if (k == corners)
          read_corners(list);
        else
          pass_over(e.properties[k]);
      }
      if (!mesh_.add_face(corners_))
        source_.fail(fmt::format("more than {} triangles", most_elements));
      source_.end_row();
    }
  }

  void read_corners(const ply_property &list) {
    const std::uint64_t n = list_count(list);
    if (n < 3)
      source_.fail(fmt::format("{} corners; a face has at least 3", n));
    source_.need_values(list.type, n);
    corners_.clear();
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::int64_t index = source_.integer(list.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_)
        source_.fail(fmt::format("vertex {} does not exist; the file has {}, counted from 0", index, vertices_));
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
  }

  const file_bytes &file_;
  const ply_header &header_;
  Source source_;
  mesh_builder mesh_;
  std::uint64_t vertices_ = 0;
  std::vector<std::uint32_t> corners_;
};

} // namespace

element_set read_ply(const file_bytes &file, const kind_info &triangle, const transform &move) {
  const ply_header header = read_ply_header(file);
  switch (header.format) {
  case ply_format::ascii:
    return body_reader<ply_ascii_source>(file, header, triangle, move).read();
  case ply_format::little_endian:
    return body_reader<ply_binary_source<std::endian::little>>(file, header, triangle, move).read();
  default:
    return body_reader<ply_binary_source<std::endian::big>>(file, header, triangle, move).read();
  }
}

} // namespace meetc::io
