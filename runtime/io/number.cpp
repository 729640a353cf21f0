#include "io/number.hpp"

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale.h>
#include <string>
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

locale_t c_locale() {
  static const locale_t c = newlocale(LC_ALL_MASK, "C", nullptr);
  return c;
}

// std::from_chars reports only "out of range", for numbers too large and too small alike, without a value. The C
// function then gives infinity, a subnormal number or zero, correctly rounded.
double round_extreme(std::string_view text, float) {
  return strtof_l(std::string(text).c_str(), nullptr, c_locale());
}
double round_extreme(std::string_view text, double) {
  return strtod_l(std::string(text).c_str(), nullptr, c_locale());
}

template <class T> bool parse(std::string_view text, double &out) {
  T value{};
  const char *const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument)
    return false;
  out = code == std::errc::result_out_of_range ? round_extreme(text, T{}) : static_cast<double>(value);
  return true;
}

} // namespace

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
