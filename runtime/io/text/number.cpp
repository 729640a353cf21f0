#include "meet/io/text/number.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace meetc::io {

namespace {

// std::from_chars accepts no '+'. After the one removed here no other sign may follow.
bool strip_plus(std::string_view &text) {
  if (text.empty() || text.front() != '+')
    return !text.empty();
  text.remove_prefix(1);
  return !text.empty() && text.front() != '+' && text.front() != '-';
}

// std::from_chars reports only "out of range", for numbers too large and too small alike, without a value. strtod would
// give one, but it rounds as the x87 control word says, which a caller's fesetround() may have changed and no guard
// sets.
double beyond_range(std::string_view text) {
  const double magnitude = take_apart(text).point > 0 ? std::numeric_limits<double>::infinity() : 0;
  return text.front() == '-' ? -magnitude : magnitude;
}

template <class T> bool parse(std::string_view text, double &out) {
  T value{};
  const char *const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument)
    return false;
  out = code == std::errc::result_out_of_range ? beyond_range(text) : static_cast<double>(value);
  return true;
}

} // namespace

decimal_digits take_apart(std::string_view text) {
  constexpr std::int64_t most = 1'000'000'000;
  decimal_digits out;
  long after = 0, exponent = 0;
  bool point = false;
  std::size_t i = text.front() == '-' || text.front() == '+' ? 1 : 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') {
      point = true;
      continue;
    }
    after += point;
    if (text[i] != '0' || !out.digits.empty())
      out.digits += text[i];
  }
  if (i < text.size()) {
    const std::string_view word = text.substr(i + 1);
    std::int64_t n = 0;
    // A number with a longer exponent is zero or infinite, or it has as many digits, which no file holds.
    if (!parse_integer(word, n) || n > most || n < -most)
      n = word.starts_with('-') ? -most : most;
    exponent = static_cast<long>(n);
  }
  out.unit = exponent - after;
  out.point = out.unit + static_cast<long>(out.digits.size());
  return out;
}

bool parse_decimal(std::string_view text, precision target, double &out) {
  if (!strip_plus(text))
    return false;
  if (target == precision::float64)
    return parse<double>(text, out);
  if (!parse<float>(text, out))
    return false;
  // A number beyond float32 has a double beyond float32 too, since the limit is itself a double.
  return std::isinf(out) ? parse<double>(text, out) : true;
}

bool parse_integer(std::string_view text, std::int64_t &out) {
  if (!strip_plus(text))
    return false;
  const char *const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, out);
  return stop == end && code == std::errc{};
}

float to_float32(double value) {
  constexpr double limit = 0x1.ffffffp127; // halfway from the largest float32 to 2^128; the tie is rounded up
  if (std::abs(value) >= limit)
    return std::copysign(std::numeric_limits<float>::infinity(), value < 0 ? -1.0F : 1.0F);
  return static_cast<float>(value);
}

} // namespace meetc::io
