// PNG in memory by libpng's simplified interface, which reports errors without longjmp.
#include "meet/picture/image.hpp"

#include <png.h>
#include <stdexcept>

namespace meetc::picture {

std::vector<std::uint8_t> encode_png(const image &picture) {
  const auto w = static_cast<std::size_t>(picture.width), h = static_cast<std::size_t>(picture.height);
  if (picture.width <= 0 || picture.height <= 0 || picture.rgb.size() != w * h * 3)
    throw std::runtime_error("picture: the image is empty or malformed");
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  head.width = static_cast<png_uint_32>(w);
  head.height = static_cast<png_uint_32>(h);
  head.format = PNG_FORMAT_RGB;
  // This is an upper bound of the size, so the picture is compressed only once.
  std::vector<std::uint8_t> out(PNG_IMAGE_PNG_SIZE_MAX(head));
  png_alloc_size_t size = out.size();
  if (png_image_write_to_memory(&head, out.data(), &size, 0, picture.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("picture: libpng: ") + head.message);
  out.resize(size);
  return out;
}

} // namespace meetc::picture
