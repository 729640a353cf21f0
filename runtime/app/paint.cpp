#include "app/paint.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "io/atomic_file.hpp"
#include "picture/render.hpp"

#include <fmt/format.h>

namespace meetc::app {

namespace {

io::rgb bytes(picture::colour c) {
  return {c.r, c.g, c.b};
}

// Memory that a shape refers to.
struct kept {
  std::vector<std::uint8_t> hit; // one for each element
  std::vector<float> rows;       // used where the set's own rows do not serve
};

picture::shape shape_of(const painted &side, kept &keep) {
  const io::element_set &set = side.set;
  keep.hit.resize(side.hit.empty() ? 0 : set.elements);
  for (std::size_t i = 0; i < keep.hit.size(); ++i)
    keep.hit[i] = side.hit[set.owner_of(i)];
  picture::shape s;
  s.rows = set.data;
  s.hit = keep.hit;
  s.base = side.base;
  s.hit_colour = side.hit_colour;
  s.name = side.name;
  if (is_mesh(set)) {
    s.what = picture::form::triangles;
    s.index = set.index;
    if (set.elements == 0)
      s.rows = {}; // vertices alone are not rows
  } else if (set.kind->fields == 4) {
    s.what = picture::form::spheres;
  } else if (set.kind->points == 2) {
    s.what = picture::form::segments;
  } else if (set.kind->points == 1) {
    s.what = picture::form::spheres;
    for (std::size_t i = 0; i < set.elements; ++i)
      keep.rows.insert(keep.rows.end(), {set.data[3 * i], set.data[3 * i + 1], set.data[3 * i + 2], 0.0f});
    s.rows = keep.rows;
  } else {
    throw failure(fmt::format("a picture cannot show elements of kind {}", set.kind->name));
  }
  return s;
}

} // namespace

void write_coloured(const std::filesystem::path &path, const painted &side) {
  std::vector<io::rgb> colours(side.set.items, bytes(side.base));
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (side.hit[i])
      colours[i] = bytes(side.hit_colour);
  io::write_ply(path, side.set, colours);
}

void write_picture(const std::filesystem::path &path, const std::vector<painted> &sides, const picture::camera &from,
                   int width, int height) {
  std::vector<kept> keep(sides.size());
  std::vector<picture::shape> shapes;
  for (std::size_t i = 0; i < sides.size(); ++i)
    shapes.push_back(shape_of(sides[i], keep[i]));
  write_png(path, picture::render_panels(shapes, from, width, height));
}

void write_png(const std::filesystem::path &path, const picture::image &picture) {
  const std::vector<std::uint8_t> png = picture::encode_png(picture);
  io::write_file(path, {reinterpret_cast<const char *>(png.data()), png.size()});
}

} // namespace meetc::app
