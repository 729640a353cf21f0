#include "meet/app/output/paint.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/text/text.hpp"
#include "meet/picture/render.hpp"
#include "meet/picture/text.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <list>

namespace meetc::app {

namespace {

io::rgb bytes(picture::colour c) {
  return {c.r, c.g, c.b};
}

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

void warn_without_font() {
  static const bool warned = [] {
    if (picture::has_font())
      return false;
    std::fputs("meet: this machine has no font, so that pictures have no captions; on Debian, the package "
               "fonts-dejavu-core has one\n",
               stderr);
    return true;
  }();
  static_cast<void>(warned);
}

} // namespace

drawn_side::drawn_side(const painted &side) : owner(side.set.owner) {
  const io::element_set &set = side.set;
  picture::shape &s = shape;
  hit_.resize(side.hit.empty() ? 0 : set.elements);
  for (std::size_t i = 0; i < hit_.size(); ++i)
    hit_[i] = side.hit[set.owner_of(i)];
  s.rows = set.data;
  if (!is_mesh(set) && !set.index.empty()) { // lines or points of a mesh
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
  if (is_mesh(set)) {
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
    throw failure(fmt::format("a picture cannot show elements of kind {}", set.kind->name));
  }
}

void check_picture(const std::filesystem::path &to) {
  const std::string extension = io::lower_case(to.extension().string());
  if (!extension.empty() && extension != ".png")
    throw failure(fmt::format("--image {}: pictures are PNG; name it {}", to.string(),
                              std::filesystem::path(to).replace_extension(".png").string()));
}

void write_coloured(const std::filesystem::path &path, const painted &side) {
  std::vector<io::rgb> colours(side.set.items, bytes(side.base));
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (side.hit[i])
      colours[i] = bytes(side.hit_colour);
  io::write_ply(path, side.set, colours);
}

void write_picture(const std::filesystem::path &path, const std::vector<painted> &sides, const picture_view &view) {
  warn_without_font();
  std::list<drawn_side> drawn;
  std::vector<picture::shape> shapes;
  for (const painted &side : sides)
    shapes.push_back(drawn.emplace_back(side).shape);
  write_png(path, picture::render_panels(shapes, view.from, view.width, view.height));
}

void write_png(const std::filesystem::path &path, const picture::image &picture) {
  const std::vector<std::uint8_t> png = picture::encode_png(picture);
  io::write_file(path, {reinterpret_cast<const char *>(png.data()), png.size()});
}

} // namespace meetc::app
