// A way down a hierarchy by fours, and what it has left beside it.
//
// It keeps a byte for each level above the place where it is: which children of that node, up to three, are still to be
// entered, in their order. The bytes of all levels are one number, to which a step down appends one, so that a thread keeps
// them in registers and needs no stack.
#ifndef MEETC_VOLUME_FOURS_WAY_HPP
#define MEETC_VOLUME_FOURS_WAY_HPP

#include <meetc/volume/first_line.hpp>

#include <bit>

namespace meetc::cuda {

inline constexpr std::uint32_t nowhere = ~std::uint32_t{0};

class fours_way {
public:
  // The number of a node or an element.
  MEETC_HD std::uint32_t at() const { return at_; }
  // Begins at the root.
  MEETC_HD void start() { *this = fours_way(0); }
  fours_way() = default; // it is nowhere

  // Enters the child of the first of these keys of the node where it is, if that is not left out; else goes on.
  MEETC_HD void enter(const std::uint32_t (&keys)[4]) {
    if (keys[0] == left_out) {
      next();
      return;
    }
    std::uint32_t others = 0, count = 0;
    for (int i = 3; i > 0; --i)
      if (keys[i] != left_out)
        others = others << 2 | (keys[i] & 3), ++count;
    for (int i = words - 1; i > 0; --i)
      left_[i] = left_[i] << 8 | left_[i - 1] >> 24;
    left_[0] = left_[0] << 8 | count << 6 | others;
    at_ = 4 * at_ + 1 + (keys[0] & 3);
  }
  // Goes on to the next child that is left, of the lowest node that has any.
  MEETC_HD void next() {
    int up = 1;
    while (left_[0] == 0 && up < 4 * words - 3) {
      for (int i = 0; i + 1 < words; ++i)
        left_[i] = left_[i + 1];
      left_[words - 1] = 0, up += 4;
    }
    if (left_[0] == 0) {
      at_ = nowhere;
      return;
    }
    const int bytes = lowest(left_[0]) / 8;
    for (int i = 0; bytes > 0 && i < words; ++i)
      left_[i] = left_[i] >> 8 * bytes | (i + 1 < words ? left_[i + 1] << (32 - 8 * bytes) : 0);
    up += bytes;
    const std::uint32_t mine = left_[0] & 0xff,
                        rest = mine >= 2U << 6 ? ((mine >> 6) - 1) << 6 | (mine & 0x3f) >> 2 : 0;
    left_[0] = (left_[0] & ~std::uint32_t{0xff}) | rest;
    const std::uint32_t above = (at_ - (0x55555555U & ((std::uint32_t{1} << 2 * up) - 1))) >> 2 * up;
    at_ = 4 * above + 1 + (mine & 3);
  }

private:
  static constexpr int words = 4;
  static_assert(4 * words > fours_levels);
  MEETC_HD explicit fours_way(std::uint32_t at) : at_(at) {}
  // The number of the lowest bit that is set.
  MEETC_HD static int lowest(std::uint32_t x) {
#if defined(__CUDA_ARCH__)
    return __ffs(static_cast<int>(x)) - 1;
#else
    return std::countr_zero(x);
#endif
  }

  std::uint32_t at_ = nowhere;
  std::uint32_t left_[words] = {}; // the lowest byte is that of the level just above
};

} // namespace meetc::cuda

#endif
