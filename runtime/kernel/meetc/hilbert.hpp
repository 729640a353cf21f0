// The order of points along Hilbert's curve.
//
// Blocks of neighbours along the curve have small boxes, for each two consecutive cells share a face. (Along Morton's curve,
// blocks straddle its jumps.)
#ifndef MEETC_HILBERT_HPP
#define MEETC_HILBERT_HPP

#include <meetc/support.hpp>

#include <cstdint>

namespace meetc {

// Bit i becomes bit 3 i, of ten.
MEETC_HD constexpr std::uint32_t every_third_bit(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

// The place along the curve of the cell x, y, z of 2^bits cells along each axis, 1 <= bits <= 10 (Skilling, Programming
// the Hilbert curve, 2004).
MEETC_HD constexpr std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
  std::uint32_t axis[3] = {x, y, z};
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1)
    for (std::uint32_t &a : axis) {
      const std::uint32_t below = bit - 1, swapped = a & bit ? below : (axis[0] ^ a) & below;
      axis[0] ^= swapped;
      if (!(a & bit) && &a != axis)
        a ^= swapped;
    }
  axis[1] ^= axis[0], axis[2] ^= axis[1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1)
    flips ^= axis[2] & bit ? bit - 1 : 0;
  return every_third_bit(axis[0] ^ flips) << 2 | every_third_bit(axis[1] ^ flips) << 1 |
         every_third_bit(axis[2] ^ flips);
}

} // namespace meetc

#endif
