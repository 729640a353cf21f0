// Decimal text to float32, rounded once and exactly, which also tells whether the number moved.
//
// Problem: reading coordinates takes most of a program's time, and std::from_chars neither tells the move by rounding
// nor gives values below its range. Method: the digits make an integer w, and w * 10^e in double, with a table of
// powers, is within 3/2 units in the last place of the decimal: w, the power and the product are each rounded once. Its
// float32 is that of the decimal unless a boundary between two float32 numbers lies within that distance, since
// rounding is monotonic; the low bits of the double tell. About one in 10^7 random decimals is left, and goes to
// std::from_chars with all that is unusual: more than 19 digits, subnormal numbers, infinities, words.
#ifndef MEETC_IO_TEXT_DECIMAL_HPP
#define MEETC_IO_TEXT_DECIMAL_HPP

#include "meet/io/text/rounded.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace meetc::io {

// The number of bytes that must be readable after the end of a text. The first of them ends a number.
inline constexpr std::size_t text_slack = 16;

// 10^0 to 10^27 in double, each rounded once (those up to 10^22 are exact).
inline constexpr int most_power = 27;
inline constexpr double powers_of_ten[most_power + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                                         1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
                                                         1e20, 1e21, 1e22, 1e23, 1e24, 1e25, 1e26, 1e27};

// Adds the move from w * 10^e to f, if there is one. The double `read` is within 3/2 units of the decimal. Exact.
void count_move(std::uint64_t w, int e, double read, float f, rounded_numbers &moved);

// Reads the whole of a word, of any length. Returns false where it is no decimal number. Beyond the largest float32 the
// result is infinite, and "inf" and "nan" are read as such; neither counts as moved.
bool read_decimal_word(std::string_view word, float &out, rounded_numbers &moved);

namespace decimal_detail {

inline bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

// 10^0 to 10^8.
inline constexpr std::uint64_t short_powers[9] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

// The digits that start here, appended to w modulo 2^64. Up to eight at once, without a branch on their number, on a
// little-endian machine (after Lemire, "Number parsing at a gigabyte per second", 2021).
inline const char *digits(const char *at, std::uint64_t &w) {
  if constexpr (std::endian::native == std::endian::little)
    for (;;) {
      std::uint64_t v;
      std::memcpy(&v, at, 8);
      // Zero in each byte up to the first that is no digit; a carry comes out of none before it.
      const std::uint64_t other = ((v & 0xf0f0f0f0f0f0f0f0) ^ 0x3030303030303030) |
                                  (((v + 0x0606060606060606) & 0xf0f0f0f0f0f0f0f0) ^ 0x3030303030303030);
      const int n = std::countr_zero(other) / 8;
      v = ((v - 0x3030303030303030) << (32 - 4 * n)) << (32 - 4 * n); // zeros before the n digits
      v = v * 10 + (v >> 8);
      const std::uint64_t low = (v & 0x000000ff000000ff) * 0x000f424000000064, // 100 + 10^6 2^32
          high = ((v >> 16) & 0x000000ff000000ff) * 0x0000271000000001;        // 1 + 10^4 2^32
      w = w * short_powers[n] + ((low + high) >> 32);
      at += n;
      if (n < 8)
        return at;
    }
  for (; is_digit(*at); ++at)
    w = 10 * w + static_cast<std::uint64_t>(*at - '0');
  return at;
}

} // namespace decimal_detail

// Reads the decimal that starts at `at`, with one leading sign at most, and returns its end; null if it is none or an
// unusual one, which read_decimal_word() then judges. The caller checks that the word ends there, and provides
// text_slack bytes after the text.
inline const char *read_decimal(const char *at, float &out, rounded_numbers &moved) {
  using namespace decimal_detail;
  const bool negative = *at == '-';
  at += negative || *at == '+';
  std::uint64_t w = 0;
  const char *const first = at;
  at = digits(at, w);
  std::ptrdiff_t count = at - first;
  int e = 0;
  if (*at == '.') {
    const char *const point = ++at;
    at = digits(at, w);
    count += at - point;
    if (at - point > 100)
      return nullptr;
    e = -static_cast<int>(at - point);
  }
  if (count == 0)
    return nullptr;
  if (count > 19) { // leading zeros do not count
    for (const char *z = first; *z == '0' || *z == '.'; ++z)
      count -= *z == '0';
    if (count > 19)
      return nullptr;
  }
  if (*at == 'e' || *at == 'E') {
    const bool minus = at[1] == '-';
    at += minus || at[1] == '+' ? 2 : 1;
    int n = 0;
    const char *const start = at;
    for (; is_digit(*at) && at - start < 4; ++at)
      n = 10 * n + (*at - '0');
    if (at == start || is_digit(*at))
      return nullptr;
    e += minus ? -n : n;
  }
  if (w == 0) {
    out = negative ? -0.0F : 0.0F;
    return at;
  }
  if (e < -most_power || e > most_power || w >> 63 != 0)
    return nullptr;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(w));
  const double d = e < 0 ? whole / powers_of_ten[-e] : whole * powers_of_ten[e];
  // The low 29 bits of a boundary between two float32 numbers are a one and 28 zeros; d is within 3/2 units of the
  // decimal, and 8 are left to be sure. Outside of the normal range boundaries have other bits.
  const auto low = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(d)) & 0x1fffffffU;
  if (low - (0x10000000U - 8) <= 16 || !(d > 0x1.00001p-126 && d < 0x1.fffffcp127))
    return nullptr;
  const auto f = static_cast<float>(d);
  // |decimal - float32| <= 2^-24 w 10^e is at most half a unit 10^e for shorter numbers.
  if (w >= std::uint64_t{1} << 23)
    count_move(w, e, d, f, moved);
  out = negative ? -f : f;
  return at;
}

} // namespace meetc::io

#endif
