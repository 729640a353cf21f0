// The wanted rows of a PLY body, and the properties that hold their numbers.
#ifndef MEETC_IO_MESH_PLY_ROWS_HPP
#define MEETC_IO_MESH_PLY_ROWS_HPP

#include "meet/io/mesh/mesh.hpp"
#include "meet/io/mesh/ply_header.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace meetc::io {

struct ply_layout {
  std::string file;
  const ply_header *header = nullptr;
  const ply_element *vertex = nullptr, *face = nullptr; // face: null if the file has none
  std::vector<int> slots;  // for each property of a vertex its coordinate: 0, 1, 2, or -1 for one to skip
  std::size_t corners = 0; // the property of a face that lists its corners

  std::size_t vertices() const { return vertex->count; }
};

// Throws io::error if the header is not that of a mesh or of points.
ply_layout layout_of(const std::string &file, const ply_header &header);

// The message on a corner whose vertex does not exist.
std::string describe_missing_vertex(std::int64_t index, std::size_t vertices);

// Bodies. `offset` and `line` say where they start. OFF is read as ascii with comments and with colours after a row.
mesh_part read_ply_ascii(const file_bytes &file, const ply_layout &layout, bool off, const read_request &q);
mesh_part read_ply_binary(const file_bytes &file, const ply_layout &layout, const read_request &q);

} // namespace meetc::io

#endif
