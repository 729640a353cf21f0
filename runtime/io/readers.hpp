// The readers behind read(), one for each format. They throw io::error for bad input.
#ifndef MEETC_IO_READERS_HPP
#define MEETC_IO_READERS_HPP

#include "io/element_set.hpp"
#include "io/file_bytes.hpp"
#include "io/transform.hpp"

#include <span>

namespace meetc::io {

element_set read_ply(const file_bytes &file, const kind_info &triangle, const transform &move);
element_set read_obj(const file_bytes &file, const kind_info &triangle, const transform &move);
element_set read_stl(const file_bytes &file, const kind_info &triangle, const transform &move);
element_set read_csv(const file_bytes &file, std::span<const kind_info *const> kinds, const transform &move);

} // namespace meetc::io

#endif
