// Reads the elements of a file.
#ifndef MEETC_IO_READ_HPP
#define MEETC_IO_READ_HPP

#include "io/element_set.hpp"
#include "io/error.hpp"
#include "io/transform.hpp"

#include <filesystem>
#include <span>

namespace meetc::io {

// Reads a set of elements of one of `kinds`. The extension says the format, in any case: .ply (ascii and
// binary, both byte orders), .obj and .stl (both) are meshes and give the kind named "triangle"; .csv gives
// the kind whose `csv` its first line is. Coordinates are moved and rounded as transform.hpp says, and are
// finite. Throws io::error, and nothing else, for whatever is wrong with the file, the kinds or the
// transform.
element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                 const transform &move = {});

} // namespace meetc::io

#endif
