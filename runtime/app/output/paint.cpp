#include "meet/app/output/paint.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
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
