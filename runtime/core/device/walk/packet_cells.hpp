// core/device/walk/packet_cells.hpp: boxes in whole numbers, so that two are compared in a few instructions.
//
// Problem: a warp compares some hundred boxes with each of a packet's elements, by six comparisons of floats, and the
// device is bound by the instructions. Method: the packet's box is cut into 511 cells along each axis. The cell of a
// number is a monotone function of it, whatever is rounded, so that boxes which touch have cells that do; three cells are
// one word, whose differences are taken together. Boxes that touch by their cells are to be compared again.
#ifndef MEETC_CORE_DEVICE_WALK_PACKET_CELLS_HPP
#define MEETC_CORE_DEVICE_WALK_PACKET_CELLS_HPP

#include "meetc/volume/tree.hpp"

namespace meetc::cuda {

// The cells of a box's two ends, each in ten bits, of which the highest is 1 in `high` and 0 in `low`.
struct cell_box {
  std::uint32_t low, high;
};

class packet_cells {
public:
  packet_cells() = default;
  // The ends are finite, low <= high; an axis along which they are equal, or too far apart for float32, tells little or
  // nothing.
  __device__ explicit packet_cells(const tree_box &around) {
    for (int k = 0; k < 3; ++k) {
      // The difference of -0 and 0 is -0, by which `per` would be negative.
      const float size = fabsf(around.high[k] - around.low[k]);
      from_[k] = around.low[k], per_[k] = __fdividef(1.0F, size); // roughly
    }
  }

  // The ends may be infinite, and not NaN.
  __device__ cell_box of(const tree_box &b) const { return {word(b.low), word(b.high) | guards}; }

  // Shifts a bit into `bits`: whether two boxes touch by their cells, as they do if they touch.
  __device__ static void push(std::uint32_t &bits, const cell_box &x, const cell_box &y) {
    // A guard is lost where an end lies below the other.
    const std::uint32_t kept = (x.high - y.low) & (y.high - x.low) & guards;
#if defined(__CUDA_ARCH__)
    [[maybe_unused]] std::uint32_t sum; // the carry says whether all are kept
    asm("add.cc.u32 %0, %2, %3;\n\taddc.u32 %1, %1, %1;" : "=r"(sum), "+r"(bits) : "r"(kept), "r"(0U - guards));
#else
    bits = 2 * bits + (kept == guards);
#endif
  }

private:
  static constexpr float last = 511, whole = 8388608; // 2^23: its last bits are a number that is added to it
  static constexpr std::uint32_t guards = 1U << 9 | 1U << 19 | 1U << 29;

  __device__ std::uint32_t word(const float (&end)[3]) const {
    std::uint32_t w = 0;
    for (int k = 2; k >= 0; --k) {
      // NaN, which is 0 times infinity, becomes 0: that is where `per` is 0, and 0 times what is finite too, or where the end
      // is `from`.
      const float share = __saturatef((end[k] - from_[k]) * per_[k]);
      w = (w << 10) + __float_as_uint(__fmaf_rn(share, last, whole));
    }
    return w - 0x4b000000; // the bits of `whole`, which are shifted out of the other two
  }

  float from_[3], per_[3]; // of each axis, the first number, and 1 over the length
};

} // namespace meetc::cuda

#endif
