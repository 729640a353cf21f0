// picture/image.hpp: a picture in memory, and its file format.
#ifndef MEETC_PICTURE_IMAGE_HPP
#define MEETC_PICTURE_IMAGE_HPP

#include "meet/picture/palette.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meetc::picture {

struct image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb; // rows from the top, three bytes for each pixel
  colour at(int x, int y) const {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

// A PNG file in memory. Throws std::runtime_error if libpng fails or the image is malformed or empty.
std::vector<std::uint8_t> encode_png(const image &picture);

} // namespace meetc::picture

#endif
