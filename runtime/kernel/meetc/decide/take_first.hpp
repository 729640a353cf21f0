// Keeps for each element of a set the hit that comes first in a total order, whichever hit is found first.
#ifndef MEETC_DECIDE_TAKE_FIRST_HPP
#define MEETC_DECIDE_TAKE_FIRST_HPP

#include <meetc/environment/environment.hpp>

MEETC_NAMESPACE(meetc) {

// Whether an element comes before another, by their order along the segment. If both are met at one point (order 0),
// the lesser number comes first.
MEETC_HD inline bool comes_before(int order, std::uint32_t number, std::uint32_t other) {
  return order < 0 || (order == 0 && number < other);
}

// Puts `hit` into a cell that other threads fill at the same time, unless the hit that the cell holds comes before it.
// `now` is a value that the cell was seen to hold; `none` marks an empty cell. before(x, y) says whether x comes before
// y. swap(expected, x) is a compare-and-swap: it puts x into the cell if the cell holds `expected`, and returns the
// value held.
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
