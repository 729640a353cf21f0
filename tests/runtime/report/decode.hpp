// Reads a report back, by code of its own: the two places of the page, base64, zlib and the arrays.
#ifndef MEETC_TESTS_REPORT_DECODE_HPP
#define MEETC_TESTS_REPORT_DECODE_HPP

#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace decoded {

using nlohmann::json;

inline std::string element(std::string_view page, std::string_view start) {
  const std::size_t at = page.find(start);
  if (at == std::string_view::npos)
    throw std::runtime_error("the page has no " + std::string(start));
  const std::size_t begin = at + start.size(), end = page.find("</script>", begin);
  return std::string(page.substr(begin, end - begin));
}

inline std::vector<std::uint8_t> from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> out;
  unsigned bits = 0, held = 0;
  for (const char c : text) {
    if (c == '=')
      break;
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos)
      throw std::runtime_error("no base64");
    bits = bits << 6 | static_cast<unsigned>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      out.push_back(static_cast<std::uint8_t>(bits >> held & 255));
    }
  }
  return out;
}

inline std::vector<std::uint8_t> inflated(const std::vector<std::uint8_t> &packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK)
    throw std::runtime_error("zlib");
  stream.next_in = const_cast<std::uint8_t *>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  std::vector<std::uint8_t> out;
  int said = Z_OK;
  while (said == Z_OK) {
    std::uint8_t some[4096];
    stream.next_out = some;
    stream.avail_out = sizeof some;
    said = inflate(&stream, Z_NO_FLUSH);
    out.insert(out.end(), some, some + (sizeof some - stream.avail_out));
  }
  inflateEnd(&stream);
  if (said != Z_STREAM_END)
    throw std::runtime_error("no zlib stream");
  return out;
}

using numbers = std::vector<std::uint32_t>;

struct page {
  json header;
  std::vector<std::uint8_t> all;

  explicit page(std::string_view html)
      : header(json::parse(element(html, "<script id=\"meet-json\" type=\"application/json\">"))),
        all(inflated(from_base64(element(html, "<script id=\"meet-bytes\" type=\"text/plain\">")))) {}

  std::vector<std::uint8_t> bytes(const json &extent) const {
    const std::size_t begin = extent.at(0), size = extent.at(1);
    if (begin + size > all.size())
      throw std::out_of_range("an array beyond the bytes");
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(begin);
    return {from, from + static_cast<std::ptrdiff_t>(size)};
  }
  numbers varints(const json &extent) const {
    numbers out;
    std::uint32_t value = 0;
    int shift = 0;
    for (const std::uint8_t b : bytes(extent)) {
      value |= std::uint32_t{b & 127u} << shift;
      shift += 7;
      if (b < 128) {
        out.push_back(value);
        value = 0, shift = 0;
      }
    }
    return out;
  }
  static std::uint32_t unzigzag(std::uint32_t v) { return v & 1 ? ~(v >> 1) : v >> 1; }
  numbers differences(const json &extent) const {
    numbers out = varints(extent);
    std::uint32_t last = 0;
    for (std::uint32_t &v : out)
      last = v = last + unzigzag(v);
    return out;
  }
  numbers corners(const json &extent) const {
    numbers out = varints(extent);
    std::uint32_t next = 0;
    for (std::uint32_t &v : out) {
      v = next - v;
      next += v == next;
    }
    return out;
  }
  std::vector<float> floats(const json &extent) const {
    const std::vector<std::uint8_t> from = bytes(extent);
    std::vector<float> out(from.size() / 4);
    for (std::size_t i = 0; i < out.size(); ++i) {
      std::uint32_t bits = 0;
      for (std::size_t plane = 0; plane < 4; ++plane)
        bits |= std::uint32_t{from[plane * out.size() + i]} << 8 * plane;
      std::memcpy(&out[i], &bits, 4);
    }
    return out;
  }
  std::vector<std::array<int, 3>> points(const json &extent, std::size_t n) const {
    const std::vector<std::uint8_t> from = bytes(extent);
    if (from.size() != 6 * n)
      throw std::runtime_error("points");
    std::vector<std::array<int, 3>> out(n);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      unsigned last = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const unsigned coded = from[2 * axis * n + i] | static_cast<unsigned>(from[(2 * axis + 1) * n + i]) << 8;
        last = (last + unzigzag(coded)) & 0xffff;
        out[i][axis] = static_cast<int>(last);
      }
    }
    return out;
  }
};

} // namespace decoded

#endif
