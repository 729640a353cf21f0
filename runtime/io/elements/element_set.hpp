// The result of a reader: the elements of one file, all of one kind, ready for a device.
#ifndef MEETC_IO_ELEMENTS_ELEMENT_SET_HPP
#define MEETC_IO_ELEMENTS_ELEMENT_SET_HPP

#include "meet/core/views/view.hpp"
#include "meet/io/text/rounded.hpp"
#include "meetc/support.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meetc::io {

// The largest number of elements, items or vertices in a set, since indices have 32 bits.
inline constexpr std::size_t most_elements = 0xffffffff;

// Lists of vertices, one after the other, such as the corners of polygons.
struct vertex_lists {
  std::vector<std::uint32_t> vertices; // of all lists
  std::vector<std::uint32_t> counts;   // of each list; empty where all have `common`
  std::size_t common = 3, lists = 0;

  // Makes the last n of `vertices` a list.
  void end_list(std::size_t n) {
    if (n != common && counts.empty())
      counts.assign(lists, static_cast<std::uint32_t>(common));
    ++lists;
    if (n != common || !counts.empty())
      counts.push_back(static_cast<std::uint32_t>(n));
  }
  std::size_t count(std::size_t i) const { return counts.empty() ? common : counts[i]; }
};

// There are two layouts. Indexed (PLY, OBJ, OFF): `data` holds vertices x, y, z, and `index` holds kind->points vertices
// for each element. Rows (STL, CSV, points): `index` is empty, and `data` holds `elements` rows of kind->fields floats.
struct element_set {
  const kind_info *kind = nullptr;
  std::vector<float> data;          // finite, rounded to float32, then transformed
  std::vector<std::uint32_t> index; // each below `vertices`
  // Element i belongs to item owner[i] of the file: a polygon is cut into several triangles, and a polyline into several
  // segments, which follow each other. Empty: element i is item i.
  std::vector<std::uint32_t> owner;
  vertex_lists polygons; // the corners of the items, where a polygon was cut; else empty
  std::size_t elements = 0;
  std::size_t items = 0;    // as the file counts: faces, facets, polylines, rows
  std::size_t vertices = 0; // as the file counts; 3 for each facet of STL, 0 for CSV
  rounded_numbers rounded;  // by reading, of all coordinates and lengths of the file
  // Notes on the file for its user: left-out parts, and polygons that are not planar or cross themselves.
  std::vector<std::string> notes;

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

// Borrows the set's memory: valid until the set is changed or destroyed.
inline view view_of(const element_set &set) {
  view v;
  v.data = set.data.data();
  v.elements = set.elements;
  if (set.index.empty()) {
    v.stride_bytes = static_cast<std::size_t>(set.kind->fields) * sizeof(float);
    return v;
  }
  v.vertices = set.data.size() / 3;
  v.stride_bytes = 3 * sizeof(float);
  v.index = set.index.data();
  return v;
}

} // namespace meetc::io

#endif
