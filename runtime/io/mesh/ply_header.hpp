// The header of a PLY file: the elements that follow, in file order, with the types of their properties.
#ifndef MEETC_IO_MESH_PLY_HEADER_HPP
#define MEETC_IO_MESH_PLY_HEADER_HPP

#include "meet/io/files/file_bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meetc::io {

enum class ply_type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class ply_format : std::uint8_t { ascii, little_endian, big_endian };

constexpr std::size_t size_of(ply_type t) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(t)];
}
constexpr bool is_real(ply_type t) {
  return t == ply_type::float32 || t == ply_type::float64;
}

struct ply_property {
  std::string name;
  ply_type type;       // of the value, or of a list's values
  bool list = false;   // a count, then that number of values
  ply_type count_type; // an integer type; for lists only
};

struct ply_element {
  std::string name;
  std::uint64_t count = 0; // as the header says, to be trusted only after a comparison with the size of the file
  std::vector<ply_property> properties;
};

struct ply_header {
  ply_format format = ply_format::ascii;
  std::vector<ply_element> elements; // in file order
  std::size_t body_offset = 0, body_line = 0;
};

// Throws io::error `FILE:LINE: what` if the header breaks the rules of the format. The elements "vertex" and "face"
// occur once each.
ply_header read_ply_header(const file_bytes &file);

} // namespace meetc::io

#endif
