// Reads decimal text as numbers, rounded once, in every locale.
#ifndef MEETC_IO_TEXT_NUMBER_HPP
#define MEETC_IO_TEXT_NUMBER_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace meetc::io {

enum class precision : std::uint8_t { float32, float64 };

// Reads the whole of `text` as a decimal number and rounds it directly to the given precision. Returns false where the
// text is not one (empty, trailing characters, hexadecimal). One leading sign is accepted, and "inf" and "nan" are read
// as such. A result below the smallest subnormal is rounded to that or to zero. A number beyond float32 becomes a value
// that to_float32 rounds to infinity, so that a message can show it.
bool parse_decimal(std::string_view text, precision target, double &out);

// The magnitude of a finite decimal: 0.DIGITS * 10^point, without leading zeros; zero has no digits. The last written digit
// has the weight 10^unit. An exponent beyond 10^9 counts as 10^9.
struct decimal_digits {
  std::string digits;
  long point = 0, unit = 0;
};

// `text` is one that parse_decimal() reads as a finite number, or as one beyond its range.
decimal_digits take_apart(std::string_view text);

// Reads the whole of `text` as a decimal integer. Returns false where it is not one or does not fit.
bool parse_integer(std::string_view text, std::int64_t &out);

// Rounds to nearest, ties to even. Beyond the largest float32 the result is an infinity, as in IEEE 754 (the bare
// conversion leaves that case undefined).
float to_float32(double value);

} // namespace meetc::io

#endif
