// The order of points along Hilbert's curve.
//
// Blocks of neighbours along the curve have small boxes, since any two consecutive cells share a face. (Morton's curve
// jumps, and a block across a jump has a large box.)
#ifndef MEETC_VOLUME_HILBERT_HPP
#define MEETC_VOLUME_HILBERT_HPP

#include <meetc/environment/environment.hpp>

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

// The same by a table, for many places. It takes the cell's bits from the highest to the lowest, one of x, y and z at a
// step, which are the step's digit. The state of a step is the exchange and inversion of the axes that the steps before
// have made for all lower bits.
class hilbert_steps {
public:
  constexpr hilbert_steps() {
    for (std::uint32_t s = 0; s < states; ++s)
      for (std::uint32_t digit = 0; digit < 8; ++digit)
        steps_[s * 8 + digit] = step(s, digit);
  }
  // As hilbert_place().
  MEETC_HD constexpr std::uint32_t place(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) const {
    const std::uint32_t digits = every_third_bit(x) << 2 | every_third_bit(y) << 1 | every_third_bit(z);
    std::uint32_t at = 0, out = 0; // the state, times 8
    for (int shift = 3 * (bits - 1); shift >= 0; shift -= 3) {
      const std::uint32_t next = steps_[at | (digits >> shift & 7)];
      out = out << 3 | (next & 7);
      at = next & ~7U;
    }
    return out;
  }

private:
  static constexpr std::uint32_t states = 96; // 6 exchanges, 8 inversions of axes, and whether the digits are inverted

  // The next state, times 8, and the digit of the place.
  static constexpr std::uint16_t step(std::uint32_t state, std::uint32_t digit) {
    constexpr std::uint32_t orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const std::uint32_t *const order = orders[state / 16];
    std::uint32_t from[3] = {order[0], order[1], order[2]}, inverted[3] = {}, bit[3] = {};
    for (std::uint32_t k = 0; k < 3; ++k) {
      inverted[k] = state >> (1 + k) & 1;
      bit[k] = (digit >> (2 - from[k]) & 1) ^ inverted[k];
    }
    for (std::uint32_t k = 0; k < 3; ++k)
      if (bit[k] != 0) {
        inverted[0] ^= 1;
      } else {
        const std::uint32_t axis = from[0], inverse = inverted[0];
        from[0] = from[k], inverted[0] = inverted[k];
        from[k] = axis, inverted[k] = inverse;
      }
    const std::uint32_t first = bit[0], second = bit[1] ^ first, third = bit[2] ^ second, flips = state & 1;
    std::uint32_t next = 0;
    while (orders[next][0] != from[0] || orders[next][1] != from[1])
      ++next;
    next = next * 16 + inverted[2] * 8 + inverted[1] * 4 + inverted[0] * 2 + (flips ^ third);
    const std::uint32_t out = (first ^ flips) << 2 | (second ^ flips) << 1 | (third ^ flips);
    return static_cast<std::uint16_t>(next << 3 | out);
  }

  std::uint16_t steps_[states * 8] = {};
};

} // namespace meetc

#endif
