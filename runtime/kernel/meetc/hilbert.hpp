// The order of points along Hilbert's curve.
//
// Blocks of neighbours along the curve have small boxes, for each two consecutive cells share a face. (Along Morton's curve,
// blocks straddle its jumps.)
#ifndef MEETC_HILBERT_HPP
#define MEETC_HILBERT_HPP

#include <meetc/support.hpp>

#include <cstdint>

namespace meetc {

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
  std::uint32_t place = 0;
  for (int i = bits - 1; i >= 0; --i)
    for (const std::uint32_t a : axis)
      place = place << 1 | ((a ^ flips) >> i & 1);
  return place;
}

} // namespace meetc

#endif
