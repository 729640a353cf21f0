// app/output/paint.hpp: shows the hits of two sets as coloured meshes and as a picture.
#ifndef MEETC_APP_OUTPUT_PAINT_HPP
#define MEETC_APP_OUTPUT_PAINT_HPP

#include "meet/app/input/picture_options.hpp"
#include "meet/io/elements/element_set.hpp"
#include "meet/io/write.hpp"
#include "meet/picture/image.hpp"
#include "meet/picture/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

// One side of a picture.
struct painted {
  const io::element_set &set;
  const std::vector<std::uint8_t> &hit; // one for each item; empty: hits are not shown
  std::string name;
  picture::colour base, hit_colour;
};

// A side as it is drawn, and the memory that this refers to beside the set's own. Throws failure for a kind that cannot be
// drawn.
struct drawn_side {
  explicit drawn_side(const painted &side);
  drawn_side(const drawn_side &) = delete;
  drawn_side &operator=(const drawn_side &) = delete;
  picture::shape shape;
  std::vector<std::uint32_t> owner; // the item of each drawn element; empty: they are one to one

private:
  std::vector<std::uint8_t> hit_; // one for each element
  std::vector<float> rows_;       // to draw, if they are not the set's own
};

// Writes the mesh with a bright colour on every face that is hit and a calm one elsewhere.
void write_coloured(const std::filesystem::path &path, const painted &side);

// Throws failure for the name of a picture of another format. A name without an extension may be that of a device.
void check_picture(const std::filesystem::path &to);

// Writes a PNG of all sides together and, if there are two, of each alone. Throws io::error.
// Without a font there are no captions, and standard error tells so once.
void write_picture(const std::filesystem::path &path, const std::vector<painted> &sides, const picture_view &view = {});

void write_png(const std::filesystem::path &path, const picture::image &picture);

} // namespace meetc::app

#endif
