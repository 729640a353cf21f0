// The picture in the bytes of a PNG file, by libpng.
#ifndef MEETC_TESTS_PICTURE_DECODE_HPP
#define MEETC_TESTS_PICTURE_DECODE_HPP

#include "meet/picture/image.hpp"

#include "tests/catch.hpp"

#include <png.h>

namespace meetc::picture {

template <class Bytes> image decode(const Bytes &file) {
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&head, file.data(), file.size()) != 0);
  head.format = PNG_FORMAT_RGB;
  image out{static_cast<int>(head.width), static_cast<int>(head.height), {}};
  out.rgb.resize(PNG_IMAGE_SIZE(head));
  REQUIRE(png_image_finish_read(&head, nullptr, out.rgb.data(), 0, nullptr) != 0);
  return out;
}

} // namespace meetc::picture

#endif
