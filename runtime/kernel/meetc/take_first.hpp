// Keeps the first of many: of each element of a set, the hit that comes first in a total order, whichever is found first.
#ifndef MEETC_TAKE_FIRST_HPP
#define MEETC_TAKE_FIRST_HPP

#include <meetc/support.hpp>

MEETC_NAMESPACE(meetc) {

// Of two elements that are met at one point (order 0), the one with the lesser number counts.
MEETC_HD inline bool comes_before(int order, std::uint32_t number, std::uint32_t other) {
  return order < 0 || (order == 0 && number < other);
}

// Puts `hit` into a cell that others fill at the same time, unless what the cell holds comes before it. `now` is what the cell
// was seen to hold, `none` at first. before(x, y) says whether x comes before y. swap(expected, x) puts x into the cell if the
// cell holds `expected`, at once, and returns what the cell held.
template <class Before, class Swap>
MEETC_HD MEETC_INLINE void take_first(std::uint32_t now, std::uint32_t hit, std::uint32_t none, const Before &before,
                                      const Swap &swap) {
  while (now == none || (now != hit && before(hit, now))) {
    const std::uint32_t held = swap(now, hit);
    if (held == now)
      return;
    now = held;
  }
}

} // MEETC_NAMESPACE(meetc)

#endif
