// picture/image.hpp: a picture in memory, text on it, and its file format.
#ifndef MEETC_PICTURE_IMAGE_HPP
#define MEETC_PICTURE_IMAGE_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace meetc::picture {

struct colour {
  std::uint8_t r, g, b;
  friend bool operator==(const colour &, const colour &) = default;
};

namespace palette {
inline constexpr colour green{150, 176, 158}; // calm colours of the two sets
inline constexpr colour blue{146, 164, 190};
inline constexpr colour red{196, 152, 146};
inline constexpr colour yellow{255, 214, 0}; // hit elements of the first set
inline constexpr colour pink{255, 20, 137};  // hit elements of the second
inline constexpr colour orange{255, 128, 0}; // hit spheres
inline constexpr colour sky{20, 110, 255};   // where elements meet
inline constexpr colour ink{44, 48, 54};
} // namespace palette

struct image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb; // rows from the top, three bytes for each pixel
  colour at(int x, int y) const {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

// Draws text in a 5 by 7 bitmap font, with `scale` pixels to a dot and its upper left corner at (x, y). The text is
// ASCII and is clipped. A line takes 8 * scale pixels, a character 6 * scale.
void draw_text(image &into, int x, int y, std::string_view text, int scale, colour ink);

// A PNG file in memory. Throws std::runtime_error if libpng fails or the image is malformed or empty.
std::vector<std::uint8_t> encode_png(const image &picture);

} // namespace meetc::picture

#endif
