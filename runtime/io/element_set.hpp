// The result of a reader: the elements of one file, all of one kind, ready for a device.
#ifndef MEETC_IO_ELEMENT_SET_HPP
#define MEETC_IO_ELEMENT_SET_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meetc::io {

// There are two layouts. Indexed (meshes in PLY and OBJ): `data` holds vertices x, y, z, and `index` holds kind->points
// vertices for each element. Rows (STL, CSV): `index` is empty, and `data` holds `elements` rows of kind->fields
// floats. A mesh without faces has elements == 0 and may still have vertices in `data`; `elements` is what counts.
struct element_set {
  const kind_info *kind = nullptr;
  std::vector<float> data;          // finite, transformed, rounded once
  std::vector<std::uint32_t> index; // each below `vertices`
  // Element i belongs to item owner[i] of the file: a polygon is fanned into several elements, which follow each other.
  // Empty: element i is item i.
  std::vector<std::uint32_t> owner;
  std::size_t elements = 0;
  std::size_t items = 0;    // as the file counts: faces, facets, rows
  std::size_t vertices = 0; // as the file counts; 3 for each facet of STL, 0 for CSV

  std::size_t owner_of(std::size_t i) const { return owner.empty() ? i : owner[i]; }

  // Copies the kind->fields floats of element i in either layout.
  void row(std::size_t i, float *out) const {
    if (index.empty()) {
      const auto fields = static_cast<std::size_t>(kind->fields);
      for (std::size_t f = 0; f < fields; ++f)
        out[f] = data[i * fields + f];
      return;
    }
    const auto points = static_cast<std::size_t>(kind->points);
    for (std::size_t p = 0; p < points; ++p)
      for (std::size_t c = 0; c < 3; ++c)
        out[3 * p + c] = data[std::size_t{3} * index[i * points + p] + c];
  }
};

} // namespace meetc::io

#endif
