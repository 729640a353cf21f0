// The spatial order of a set's elements, made on a device.
#ifndef MEETC_VOLUME_TREE_ORDER_HPP
#define MEETC_VOLUME_TREE_ORDER_HPP

#include <meetc/volume/hilbert.hpp>
#include <meetc/volume/tree.hpp>

namespace meetc::cuda {

// 2^bits cells along each axis of a cube around a set. Every number is in some cell; outliers lie in the outermost.
struct hilbert_cells {
  float low[3], unit, scale; // numbers are multiplied by the power of two `unit`, so that the cube's size is no extreme
  int bits;

  hilbert_cells() = default;
  // `around`: the box around the elements' boxes. Its ends are finite if there are elements.
  MEETC_HD hilbert_cells(const tree_box &around, int bits_) : bits(bits_) {
    float half = 0; // of the size
    for (int k = 0; k < 3; ++k) {
      const float side = around.high[k] * 0.5F - around.low[k] * 0.5F;
      half = side > half ? side : half;
    }
    unit = half > 0x1p60F ? 0x1p-64F : half < 0x1p-60F ? 0x1p64F : 1;
    for (int k = 0; k < 3; ++k)
      low[k] = around.low[k] * unit;
    scale = half > 0 ? static_cast<float>(1U << bits) / (half * unit * 2) : 0;
  }

  // The place of the box's centre.
  MEETC_HD std::uint32_t place_of(const tree_box &b, const hilbert_steps &steps) const {
    std::uint32_t cell[3];
    cell_of(b, cell);
    return steps.place(cell[0], cell[1], cell[2], bits);
  }
  MEETC_HD std::uint32_t place_of(const tree_box &b) const {
    std::uint32_t cell[3];
    cell_of(b, cell);
    return hilbert_place(cell[0], cell[1], cell[2], bits);
  }

private:
  MEETC_HD void cell_of(const tree_box &b, std::uint32_t (&cell)[3]) const {
    const auto last = static_cast<float>((1U << bits) - 1);
    const float half = unit * 0.5F;
    for (int k = 0; k < 3; ++k) {
      const float at = ((b.low[k] * half + b.high[k] * half) - low[k]) * scale;
      cell[k] = static_cast<std::uint32_t>(at > 0 ? at < last ? at : last : 0.0F);
    }
  }
};

// Packed rows get their places by a box around a sample of them: row `first` and every `step` rows after it, at most
// 1024. The box around all is not needed: a pass over all rows would take as long as finding their places. A sample
// also seldom holds the few rows that lie far away.
struct sample {
  std::uint32_t step, first;

  MEETC_HD constexpr explicit sample(std::uint32_t elements) {
    constexpr std::uint32_t most = 1024;
    step = elements / most + (elements % most != 0 || elements == 0);
    first = step / 2;
  }
  // The size of the sample of so many elements.
  MEETC_HD constexpr std::uint32_t of(std::uint32_t elements) const {
    return elements > first ? (elements - first - 1) / step + 1 : 0;
  }
};

// The sort key of an element: its place, and then its number.
MEETC_HD constexpr std::uint64_t in_order(std::uint32_t place, std::uint32_t element) {
  return std::uint64_t{place} << 32 | element;
}

} // namespace meetc::cuda

#endif
