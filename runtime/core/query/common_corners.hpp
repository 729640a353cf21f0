// core/query/common_corners.hpp: which corners two elements with three corners have in common, by the corners' numbers, and in
// which order these come first in both.
#ifndef MEETC_CORE_QUERY_COMMON_CORNERS_HPP
#define MEETC_CORE_QUERY_COMMON_CORNERS_HPP

#include "meetc/support.hpp"

#include <cstdint>

namespace meetc {

// Whether a corner is the first one of its element with its number.
MEETC_HD constexpr bool is_first(const std::uint32_t *corners, int i) {
  return (i < 1 || corners[0] != corners[i]) && (i < 2 || corners[1] != corners[2]);
}

// Bit 3 c + d: corner c of the first is corner d of the second.
MEETC_HD constexpr unsigned common_bits(const std::uint32_t *mine, const std::uint32_t *theirs) {
  unsigned bits = 0;
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      bits |= static_cast<unsigned>(mine[c] == theirs[d]) << (3 * c + d);
  return bits;
}
// The bits of those corners that are the first one with their number.
MEETC_HD constexpr unsigned bits_of_first(const std::uint32_t *mine) {
  unsigned bits = 0;
  for (int c = 0; c < 3; ++c)
    bits |= is_first(mine, c) ? 7U << (3 * c) : 0U;
  return bits;
}

struct common_order {
  std::uint8_t common = 0;                   // how many corners
  std::uint8_t mine[3] = {}, theirs[3] = {}; // corners, the common ones first: theirs[i] is mine[i]
};
// For bits of first corners, as two elements have them.
MEETC_HD constexpr common_order order_by(unsigned bits) {
  common_order o;
  unsigned left_mine = 7, left_theirs = 7;
  int n = 0;
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      if ((bits >> (3 * c + d) & 1) != 0) { // the first of theirs with the number
        o.mine[n] = static_cast<std::uint8_t>(c), o.theirs[n] = static_cast<std::uint8_t>(d);
        left_mine &= ~(1U << c), left_theirs &= ~(1U << d);
        ++n;
        break;
      }
  o.common = static_cast<std::uint8_t>(n);
  int at_mine = n, at_theirs = n;
  for (int c = 0; c < 3; ++c) {
    if ((left_mine >> c & 1) != 0 && at_mine < 3)
      o.mine[at_mine++] = static_cast<std::uint8_t>(c);
    if ((left_theirs >> c & 1) != 0 && at_theirs < 3)
      o.theirs[at_theirs++] = static_cast<std::uint8_t>(c);
  }
  return o;
}

} // namespace meetc

#endif
