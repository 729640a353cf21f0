// report/bytes.hpp: the arrays of a report as bytes, and these as text.
//
// Integers are varints: seven bits a byte, the lowest first, and the high bit where more follow. Signed ones are zigzag coded
// first (0, -1, 1, -2 are 0, 1, 2, 3). Arrays of wider numbers are written as planes, all lowest bytes first, which compress
// better. All arrays stand one after another in one zlib stream, in base64.
#ifndef MEETC_REPORT_BYTES_HPP
#define MEETC_REPORT_BYTES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace meetc::report {

// The place of an array among all bytes: its first byte and its length.
using extent = std::array<std::size_t, 2>;

class byte_arrays {
public:
  extent varints(std::span<const std::uint32_t> values);
  extent differences(std::span<const std::uint32_t> values); // each from the one before, the first from 0
  // Indices into points that are numbered as they are first named: a varint of how far each lies below the number that a new
  // point would have.
  extent corners(std::span<const std::uint32_t> index);
  extent floats(std::span<const float> values);
  // Points of three numbers, each the difference from the point before, modulo 2^16.
  extent points(std::span<const std::array<std::uint16_t, 3>> points);
  extent bytes(std::span<const std::uint8_t> values);

  // All arrays so far, as base64 of a zlib stream. Throws std::runtime_error if zlib fails.
  std::string as_text() const;

private:
  void varint(std::uint32_t value);
  extent since(std::size_t begin) const { return {begin, all_.size() - begin}; }
  std::vector<std::uint8_t> all_;
};

std::string base64(std::span<const std::uint8_t> bytes);

} // namespace meetc::report

#endif
