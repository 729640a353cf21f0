// The spatial order of a set's elements, where a device makes it.
#ifndef MEETC_TREE_ORDER_HPP
#define MEETC_TREE_ORDER_HPP

#include <meetc/frame.hpp>
#include <meetc/hilbert.hpp>
#include <meetc/tree.hpp>

namespace meetc::cuda {

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

// An element as it is ordered: by its place, and then by its number.
MEETC_HD constexpr std::uint64_t in_order(std::uint32_t place, std::uint32_t element) {
  return std::uint64_t{place} << 32 | element;
}
// The cell of an element: the first bits of its place.
MEETC_HD constexpr std::uint32_t cell_of(std::uint64_t element, int place_bits, int cell_bits) {
  return static_cast<std::uint32_t>(element >> (32 + place_bits - cell_bits));
}
// How many of the elements of its cell, [begin, end) in any order, come before this one, and how many of these have its place.
struct before_in_cell {
  std::uint32_t all = 0, alike = 0;
  MEETC_HD before_in_cell(const std::uint64_t *by_cell, std::uint32_t begin, std::uint32_t end, std::uint64_t element) {
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint64_t other = by_cell[k];
      all += other < element;
      alike += other < element && other >> 32 == element >> 32;
    }
  }
};

} // namespace meetc::cuda

#endif
