// Reads the elements of a file.
#ifndef MEETC_IO_READ_HPP
#define MEETC_IO_READ_HPP

#include "io/element_set.hpp"
#include "io/error.hpp"
#include "io/transform.hpp"

#include <filesystem>
#include <span>

namespace meetc::io {

// Reads a set of elements of one of `kinds`. The extension, in upper or lower case, gives the format: .ply (ascii and
// binary, both byte orders), .obj and .stl (both) are meshes and give the kind named "triangle"; .csv gives the kind
// whose `csv` is its first line. Coordinates are moved and rounded as in transform.hpp, and are finite. Throws nothing
// but io::error, for whatever is wrong with the file, the kinds or the transform.
element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                 const transform &move = {});

} // namespace meetc::io

#endif
