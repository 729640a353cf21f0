// Numbers as bytes in a file, in either byte order and at any alignment.
#ifndef MEETC_IO_FILES_ENDIAN_HPP
#define MEETC_IO_FILES_ENDIAN_HPP

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace meetc::io {

template <class T> T load(const char *from, std::endian order) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if (order != std::endian::native)
    std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

// The bytes of a value in the given order.
template <class T> std::array<char, sizeof(T)> store(T value, std::endian order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

} // namespace meetc::io

#endif
