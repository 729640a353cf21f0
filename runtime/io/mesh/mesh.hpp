// Makes vertices and lists of them a set of triangles, segments or points, for OBJ, PLY and OFF alike.
#ifndef MEETC_IO_MESH_MESH_HPP
#define MEETC_IO_MESH_MESH_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/readers.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meetc::io {

// The content of a file or of a piece of one.
struct mesh_part {
  std::vector<float> xyz;
  vertex_lists faces, lines{{}, {}, 2, 0}, points{{}, {}, 1, 0};
  rounded_numbers rounded;
};

// Appends the parts to the first one, in order and on several threads.
void join_parts(const std::vector<mesh_part *> &parts, int threads);

// Parts that have only rows, which are moved from, as one: its xyz are all rows in order.
template <class Part> mesh_part join_rows(std::vector<Part> &parts, int threads) {
  std::vector<mesh_part> rows(parts.size());
  std::vector<mesh_part *> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    rows[i].xyz = std::move(parts[i].rows);
    rows[i].rounded = parts[i].rounded;
    all.push_back(&rows[i]);
  }
  join_parts(all, threads);
  return std::move(rows.front());
}

// The elements of the wanted kind; if no kind is wanted, the faces, else the lines or the points. A note on the parts
// left out follows `notes`. `vertices_are_points`: the vertices of a file without faces are its points. Throws
// io::error if nothing is usable, or if there are lines and points, no faces, and no wanted kind.
element_set set_of(const std::string &file, mesh_part &&all, bool vertices_are_points,
                   const std::vector<std::string> &notes, const read_request &q);

// Tests each element against the rule of its kind; `item` is "face" or "facet".
void check_rules(const element_set &set, const std::string &file, const char *item);

} // namespace meetc::io

#endif
