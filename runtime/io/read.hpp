// Reads the elements of a file.
#ifndef MEETC_IO_READ_HPP
#define MEETC_IO_READ_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/transform.hpp"
#include "meet/io/files/error.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meetc::io {

enum class file_format : std::uint8_t { ply, obj, off, stl, csv };

// Throws io::error, which begins with `option`, for an unknown name.
file_format format_named(std::string_view option, std::string_view name);

struct read_options {
  transform move = {};
  std::optional<file_format> format = {}; // none: by the extension, or for standard input by the first bytes
  std::string kind = {};                  // to take from a file that holds several; empty: see read()
  int threads = 0;                        // 0: all cores
  std::size_t piece_bytes = 0;            // of the pieces of a text that threads parse; 0: chosen by its size
};

// Reads a set of elements of one of `kinds`. The extension, in upper or lower case, gives the format: .ply (ascii and
// binary, both byte orders), .obj, .off (ascii) and .stl (both) are meshes, and .csv gives the kind whose stored numbers
// are among its columns. A mesh gives the kind named "triangle"; without faces, an OBJ gives its lines as segments
// or its points, and a PLY or OFF its vertices as points. "-" is standard input. Decimals and doubles are rounded once to
// float32, then moved as in transform.hpp; all are finite then. The result is the same for any number of threads. Throws
// io::error for any fault of the file, the kinds or the transform, and nothing else. Works under any floating-point
// control word.
element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                 const read_options &how = {});

// The same, moved.
inline element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                        const transform &move) {
  return read(path, kinds, read_options{move});
}

} // namespace meetc::io

#endif
