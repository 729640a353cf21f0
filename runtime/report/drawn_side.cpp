#include "meet/report/drawn_side.hpp"

#include "meet/core/views/pose.hpp"
#include "meet/io/elements/words.hpp"
#include "meet/io/files/error.hpp"

#include <string>
#include <utility>

namespace meetc::report {

namespace {

// The two triangles of each of its six faces.
constexpr std::size_t triangles_of_box = 12;
void add_box(const float *row, std::vector<float> &to) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (const int corner : {0, 1, 3, 0, 3, 2}) { // a bit for each other axis: 1 at the greater coordinate
        float p[3];
        p[axis] = row[3 * side + axis];
        for (int other = 0; other < 2; ++other) {
          const int k = (axis + 1 + other) % 3;
          p[k] = row[3 * (corner >> other & 1) + k];
        }
        to.insert(to.end(), p, p + 3);
      }
}

} // namespace

drawn_side::drawn_side(const painted &side) : owner(side.set.owner) {
  const io::element_set &set = side.set;
  picture::shape &s = shape;
  hit_.resize(side.hit.empty() ? 0 : set.elements);
  for (std::size_t i = 0; i < hit_.size(); ++i)
    hit_[i] = side.hit[set.owner_of(i)];
  s.rows = set.data;
  if (!io::is_mesh(set) && !set.index.empty()) { // lines or points of a mesh
    const auto fields = static_cast<std::size_t>(set.kind->fields);
    rows_.resize(fields * set.elements);
    for (std::size_t i = 0; i < set.elements; ++i)
      set.row(i, &rows_[fields * i]);
    s.rows = rows_;
  }
  s.hit = hit_;
  s.base = side.base;
  s.hit_colour = side.hit_colour;
  s.name = side.name;
  if (io::is_mesh(set)) {
    s.what = picture::form::triangles;
    s.index = set.index;
    if (set.elements == 0)
      s.rows = {}; // without an index the vertices would be drawn as triangles
  } else if (lies_along_axes(*set.kind) && set.kind->hull == 8 && set.kind->fields == 6) {
    s.parts = triangles_of_box;
    s.whole = set.kind->name;
    for (std::size_t i = 0; i < set.elements; ++i)
      add_box(&set.data[6 * i], rows_);
    s.rows = rows_;
    std::vector<std::uint8_t> of_boxes = std::move(hit_);
    hit_.clear();
    for (const std::uint8_t hit : of_boxes)
      hit_.insert(hit_.end(), triangles_of_box, hit);
    owner.resize(triangles_of_box * set.elements);
    for (std::size_t i = 0; i < owner.size(); ++i)
      owner[i] = static_cast<std::uint32_t>(set.owner_of(i / triangles_of_box));
    s.hit = hit_;
  } else if (!lies_along_axes(*set.kind) && set.kind->fields == 4) {
    s.what = picture::form::spheres;
  } else if (set.kind->points == 2) {
    s.what = picture::form::segments;
  } else if (set.kind->points == 1) {
    s.what = picture::form::spheres;
    std::vector<float> balls(4 * set.elements); // of radius 0
    for (std::size_t i = 0; i < set.elements; ++i)
      set.row(i, &balls[4 * i]);
    rows_ = std::move(balls);
    s.rows = rows_;
  } else {
    throw io::error(std::string("a picture cannot show elements of kind ") + set.kind->name);
  }
}

} // namespace meetc::report
