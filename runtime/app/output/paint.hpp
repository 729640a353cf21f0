// app/output/paint.hpp: shows the hits of two sets as coloured meshes and as a picture.
#ifndef MEETC_APP_OUTPUT_PAINT_HPP
#define MEETC_APP_OUTPUT_PAINT_HPP

#include "meet/app/input/picture_options.hpp"
#include "meet/io/write.hpp"
#include "meet/picture/image.hpp"
#include "meet/report/drawn_side.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

using report::drawn_side;
using report::painted;

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
