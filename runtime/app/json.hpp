// app/json.hpp: JSON as the program prints it: keys in the order in which they are given, one line.
#ifndef MEETC_APP_JSON_HPP
#define MEETC_APP_JSON_HPP

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace meetc::app {

using json = nlohmann::ordered_json;

// The number that this text is; null where it is none, such as "inf".
inline json number(const std::string &text) {
  json value = json::parse(text, nullptr, false);
  return value.is_number() ? value : json();
}
// Rounded to so many decimals, or significant digits.
inline json with_decimals(double x, int n) {
  return number(fmt::format("{:.{}f}", x, n));
}
inline json with_digits(double x, int n) {
  return number(fmt::format("{:.{}g}", x, n));
}

// In one line, without its end. Text that is not UTF-8 is replaced where it is not.
inline std::string in_one_line(const json &value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace meetc::app

#endif
