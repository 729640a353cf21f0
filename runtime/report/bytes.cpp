#include "meet/report/bytes.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <zlib.h>

namespace meetc::report {

namespace {

std::uint32_t zigzag(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return bits << 1 ^ (value < 0 ? ~std::uint32_t{0} : 0);
}

} // namespace

void byte_arrays::varint(std::uint32_t value) {
  for (; value >= 0x80; value >>= 7)
    all_.push_back(static_cast<std::uint8_t>(value | 0x80));
  all_.push_back(static_cast<std::uint8_t>(value));
}

extent byte_arrays::varints(std::span<const std::uint32_t> values) {
  const std::size_t begin = all_.size();
  for (const std::uint32_t v : values)
    varint(v);
  return since(begin);
}

extent byte_arrays::differences(std::span<const std::uint32_t> values) {
  const std::size_t begin = all_.size();
  std::uint32_t last = 0;
  for (const std::uint32_t v : values) {
    varint(zigzag(static_cast<std::int32_t>(v - last)));
    last = v;
  }
  return since(begin);
}

extent byte_arrays::corners(std::span<const std::uint32_t> index) {
  const std::size_t begin = all_.size();
  std::uint32_t next = 0;
  for (const std::uint32_t i : index) {
    varint(next - i);
    next += i == next;
  }
  return since(begin);
}

extent byte_arrays::floats(std::span<const float> values) {
  const std::size_t begin = all_.size();
  for (int plane = 0; plane < 4; ++plane)
    for (const float v : values)
      all_.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(v) >> 8 * plane));
  return since(begin);
}

extent byte_arrays::points(std::span<const std::array<std::uint16_t, 3>> points) {
  const std::size_t begin = all_.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::uint16_t> coded;
    coded.reserve(points.size());
    std::uint16_t last = 0;
    for (const auto &p : points) {
      const auto step = static_cast<std::int16_t>(static_cast<std::uint16_t>(p[axis] - last));
      coded.push_back(static_cast<std::uint16_t>(zigzag(step)));
      last = p[axis];
    }
    for (const int plane : {0, 8})
      for (const std::uint16_t v : coded)
        all_.push_back(static_cast<std::uint8_t>(v >> plane));
  }
  return since(begin);
}

extent byte_arrays::bytes(std::span<const std::uint8_t> values) {
  const std::size_t begin = all_.size();
  all_.insert(all_.end(), values.begin(), values.end());
  return since(begin);
}

std::string byte_arrays::as_text() const {
  uLongf size = compressBound(all_.size());
  std::vector<std::uint8_t> packed(size);
  if (compress2(packed.data(), &size, all_.data(), all_.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot compress the report");
  packed.resize(size);
  return base64(packed);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char *digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < n ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= n ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

} // namespace meetc::report
