// The moves of a file's numbers by rounding to float32: how many, and the largest.
#ifndef MEETC_IO_TEXT_ROUNDED_HPP
#define MEETC_IO_TEXT_ROUNDED_HPP

#include <bit>
#include <cstddef>
#include <cstdint>

namespace meetc::io {

// A number has moved if float32 does not hold it: a decimal if |decimal - float32| exceeds half a unit of its last written
// digit (433832.18 has moved, 0.1 has not), a double if it is no float32. Numbers that are left out of a set, such as
// colours, do not count.
struct rounded_numbers {
  std::size_t numbers = 0; // that moved
  double largest = 0;      // of the moves, rounded

  // `move` is 0 or more. Bits compare as such numbers do, under every control word.
  void add(double move) {
    ++numbers;
    keep(move);
  }
  void add(const rounded_numbers &more) {
    numbers += more.numbers;
    keep(more.largest);
  }

private:
  void keep(double move) {
    if (std::bit_cast<std::uint64_t>(move) > std::bit_cast<std::uint64_t>(largest))
      largest = move;
  }
};

} // namespace meetc::io

#endif
