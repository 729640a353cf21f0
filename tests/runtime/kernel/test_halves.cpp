// Halves: rounding to them and back, and their layout in memory.
#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <meetc/every_pair/matrix.hpp>
#include <vector>

using namespace meetc;

namespace {

// The value of a normal half according to the standard; subnormal ones are not used.
double value_of(unsigned bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  const double size = std::ldexp(1024 + fraction, exponent - 25);
  return bits & 0x8000 ? -size : size;
}
constexpr unsigned least = 0x0400, most = 0x7bff; // 2^-14 and 65504

// The nearer of two neighbours with bits n and n + 1; in a tie, the even one.
unsigned nearest(unsigned n, double x) {
  const double to_low = x - value_of(n), to_high = value_of(n + 1) - x; // exact
  if (to_low == to_high)
    return n % 2 == 0 ? n : n + 1;
  return to_low < to_high ? n : n + 1;
}

// Numbers from one half up to the next.
std::vector<double> between(unsigned n) {
  const double low = value_of(n), high = value_of(n + 1), middle = (low + high) / 2, inf = HUGE_VAL;
  return {low,    std::nextafter(low, inf),    low + (high - low) / 4,     std::nextafter(middle, 0),
          middle, std::nextafter(middle, inf), low + 3 * (high - low) / 4, std::nextafter(high, 0)};
}

} // namespace

TEST_CASE("from_half: every normal half, and zero") {
  long wrong = 0, seen = 0;
  for (unsigned h = 0; h < 65536; ++h) {
    const unsigned size = h & 0x7fff;
    if (size != 0 && (size < least || size > most))
      continue;
    ++seen;
    wrong += from_half(static_cast<std::uint16_t>(h)) != (size == 0 ? 0.0 : value_of(h));
  }
  CHECK(wrong == 0);
  CHECK(seen == 2 * (30 * 1024 + 1));
}

TEST_CASE("to_half: the nearest, ties to even, about every half") {
  long wrong = 0;
  for (unsigned n = least; n < most; ++n)
    for (const double x : between(n)) {
      const unsigned want = nearest(n, x);
      wrong += to_half(x) != want;
      wrong += to_half(-x) != (want | 0x8000);
    }
  wrong += to_half(65504) != most;
  wrong += to_half(-65504) != (most | 0x8000);
  CHECK(wrong == 0);
}

TEST_CASE("to_half: nothing below 2^-14 is left") {
  for (const double x : {0.0, 0x1p-1074, 0x1p-1022, 0x1p-24, 0x1p-15, 0x1.8p-15, 0x1.fffffffffffffp-15}) {
    CHECK(to_half(x) == 0);
    CHECK(to_half(-x) == 0);
  }
  CHECK(to_half(0x1p-14) == least);
  CHECK(to_half(-0x1p-14) == (least | 0x8000));
}

TEST_CASE("to_half_below: the largest that is not above") {
  long wrong = 0;
  for (unsigned n = least; n < most; ++n)
    for (const double x : between(n)) {
      wrong += to_half_below(x) != n;
      wrong += to_half_below(-x) != ((x == value_of(n) ? n : n + 1) | 0x8000);
    }
  CHECK(wrong == 0);
  CHECK(to_half_below(65504) == most);
  CHECK(to_half_below(-65504) == (most | 0x8000));
  for (const double x : {0x1p-1074, 0x1p-24, 0x1p-15, 0x1.fffffffffffffp-15}) {
    CHECK(to_half_below(x) == 0);
    CHECK(to_half_below(-x) == (least | 0x8000));
  }
  CHECK(to_half_below(0.0) == 0);
  CHECK(to_half_below(-0.0) == 0);
}

TEST_CASE("columns lie as the matrix units read them: each place once, eight in a piece") {
  std::vector<int> taken(matrix_block * matrix_columns);
  for (std::size_t i = 0; i < matrix_block; ++i)
    for (int k = 0; k < matrix_columns; ++k) {
      const std::size_t at = matrix_place(i, k);
      REQUIRE(at < taken.size());
      ++taken[at];
      CHECK(at / 128 == i / 8);                                                  // a tile is eight objects
      CHECK(at - matrix_place(i, k / 8 * 8) == static_cast<std::size_t>(k % 8)); // a piece is read as one
      CHECK(matrix_place(i, k / 8 * 8) % 8 == 0);
    }
  for (const int t : taken)
    REQUIRE(t == 1);
  CHECK(matrix_place(matrix_block, 0) == taken.size()); // blocks follow each other
  CHECK(matrix_place(std::size_t{0xffffffff}, 15) / 16 >= 0xffffffff - 8);
}

TEST_CASE("arrays are padded to whole blocks") {
  CHECK(matrix_padded(0) == 512);
  CHECK(matrix_padded(1) == 1024);
  CHECK(matrix_padded(512) == 1024);
  CHECK(matrix_padded(513) == 1536);
  CHECK(matrix_padded(0xffffffff) == (std::size_t{1} << 32) + 512);
}
