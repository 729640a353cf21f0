// The order of points along Hilbert's curve.
//
// Packets of neighbours along the curve have small boxes, for each two consecutive cells share a face; along Morton's,
// packets straddle its jumps.
#ifndef MEETC_HILBERT_HPP
#define MEETC_HILBERT_HPP

#include <meetc/frame.hpp>
#include <meetc/tree.hpp>

namespace meetc::cuda {

// The place along the curve of the cell x, y, z of 2^bits cells along each axis, 1 <= bits <= 10 (Skilling, Programming
// the Hilbert curve, 2004).
MEETC_HD inline std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
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

// 2^bits cells along each axis of a cube around a set. Any number is in some cell, so that outliers lie in the outermost.
struct hilbert_cells {
  double low[3], scale;
  int bits;

  hilbert_cells() = default;
  MEETC_HD hilbert_cells(const extent &around, int bits_) : bits(bits_) {
    double size = 0;
    for (int k = 0; k < 3; ++k) {
      low[k] = from_ordered(around.low[k]);
      const double side = from_ordered(around.high[k]) - low[k];
      size = side > size ? side : size;
    }
    scale = size > 0 ? static_cast<double>(1U << bits) / size : 0;
  }

  // The place of the box's centre.
  MEETC_HD std::uint32_t place_of(const tree_box &b) const {
    const std::uint32_t last = (1U << bits) - 1;
    std::uint32_t cell[3];
    for (int k = 0; k < 3; ++k) {
      const double at = (static_cast<double>(b.low[k]) / 2 + static_cast<double>(b.high[k]) / 2 - low[k]) * scale;
      cell[k] = !(at > 0) ? 0 : at < static_cast<double>(last) ? static_cast<std::uint32_t>(at) : last;
    }
    return hilbert_place(cell[0], cell[1], cell[2], bits);
  }
};

// Of an element: its place, and which of those with this place it is.
struct place_rank {
  std::uint32_t place, rank;
};

} // namespace meetc::cuda

#endif
