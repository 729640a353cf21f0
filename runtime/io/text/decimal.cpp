#include "meet/io/text/decimal.hpp"

#include "meet/io/text/number.hpp"

#include <meetc/number/grid.hpp>

#include <charconv>
#include <limits>
#include <string>
#include <vector>

namespace meetc::io {

namespace {

// |x - y| for digits of one weight and length.
std::string difference(std::string x, std::string y) {
  if (x < y)
    x.swap(y);
  int borrow = 0;
  for (std::size_t i = x.size(); i-- > 0;) {
    int d = x[i] - y[i] - borrow;
    borrow = d < 0;
    d += 10 * borrow;
    x[i] = static_cast<char>('0' + d);
  }
  return x;
}

// The move of a decimal of any length, by digits. f is finite.
void count_move_by_digits(std::string_view word, float f, rounded_numbers &moved) {
  const decimal_digits x = take_apart(word);
  if (x.digits.empty())
    return;
  double read = 0;
  parse_decimal(word, precision::float64, read);
  if (f == 0)
    return moved.add(std::abs(read));
  // Digits of weight 10^most down to 10^least; every float32 is a multiple of 10^-149 with 39 digits before the point.
  const long most = std::max(x.point, 39L), least = std::min(x.unit, -149L);
  const auto size = static_cast<std::size_t>(most - least);
  std::string a(size, '0'), b(size, '0'), half(size, '0');
  a.replace(static_cast<std::size_t>(most - x.point), x.digits.size(), x.digits);
  char text[256];
  const auto [end, code] =
      std::to_chars(text, text + sizeof text, static_cast<double>(std::abs(f)), std::chars_format::fixed, 149);
  const std::string_view exact(text, static_cast<std::size_t>(end - text));
  const std::size_t point = exact.find('.');
  b.replace(static_cast<std::size_t>(most) - point, point, exact.substr(0, point));
  b.replace(static_cast<std::size_t>(most), 149, exact.substr(point + 1));
  if (const long at = most - x.unit; at < static_cast<long>(size)) // half a unit, or 0 if that is below the last digit
    half[static_cast<std::size_t>(at)] = '5';
  const std::string apart = difference(std::move(a), std::move(b));
  if (apart <= half)
    return;
  const std::size_t first = apart.find_first_not_of('0');
  double move = 0;
  parse_decimal("0." + apart.substr(first, 30) + "e" + std::to_string(most - static_cast<long>(first)),
                precision::float64, move);
  moved.add(move);
}

// The same in integers of 128 bits; false where they are too short.
bool count_move_in_integers(std::uint64_t w, int e, float f, rounded_numbers &moved) {
  int q = 0;
  const auto m = static_cast<std::uint32_t>(std::ldexp(std::frexp(std::abs(f), &q), 24));
  q -= 24; // f = m 2^q
  if (e > 0 || e < -most_power || q >= 0 || std::bit_width(w) - q > 126 || 24 + 4 * -e > 126)
    return false;
  uint128 x = w, y = m;
  x <<= -q;
  for (int i = 0; i < -e; ++i)
    y *= 10;
  const uint128 apart = x > y ? x - y : y - x; // in units of 2^q 10^e
  if (apart * 2 > uint128{1} << -q)
    moved.add(std::ldexp(static_cast<double>(apart), q) / powers_of_ten[-e]);
  return true;
}

} // namespace

void count_move(std::uint64_t w, int e, double read, float f, rounded_numbers &moved) {
  const double half = e < 0 ? 0.5 / powers_of_ten[-e] : 0.5 * powers_of_ten[e];
  const double apart = std::abs(read - static_cast<double>(f)); // exact; the decimal lies within `slack` of `read`
  const double slack = read * 0x1p-50;
  if (apart + slack < half * (1 - 0x1p-50))
    return;
  if (apart > read * 0x1p-36 && apart - slack > half * (1 + 0x1p-50))
    return moved.add(apart);
  if (!count_move_in_integers(w, e, f, moved))
    count_move_by_digits(std::to_string(w) + "e" + std::to_string(e), f, moved);
}

bool read_decimal_word(std::string_view word, float &out, rounded_numbers &moved) {
  double value = 0;
  if (!parse_decimal(word, precision::float32, value))
    return false;
  out = to_float32(value);
  if (std::isfinite(out))
    count_move_by_digits(word, out, moved);
  return true;
}

} // namespace meetc::io
