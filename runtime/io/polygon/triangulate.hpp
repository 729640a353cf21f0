// Polygons of a mesh as triangles.
#ifndef MEETC_IO_POLYGON_TRIANGULATE_HPP
#define MEETC_IO_POLYGON_TRIANGULATE_HPP

#include "meet/io/elements/element_set.hpp"

#include <string>

namespace meetc::io {

// Sets index, owner, items and polygons of a set whose `data` are the vertices of the file. Each polygon is projected along
// the largest component of its exact Newell normal (the least axis on a tie) and cut there (ears.hpp). Adds notes on how
// many polygons are not planar and on those that cross themselves. `faces` has lists of 3 vertices or more. Throws
// io::error if there are too many triangles.
void cut_polygons(const std::string &file, vertex_lists &&faces, int threads, element_set &set);

} // namespace meetc::io

#endif
