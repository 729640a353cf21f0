// app/text/json.hpp: JSON as the program prints it, on one line, with keys in the order in which they are given.
#ifndef MEETC_APP_TEXT_JSON_HPP
#define MEETC_APP_TEXT_JSON_HPP

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace meetc::app {

using json = nlohmann::ordered_json;

// The number in this text; null if there is none, as in "inf".
inline json number(const std::string &text) {
  json value = json::parse(text, nullptr, false);
  return value.is_number() ? value : json();
}
// Rounded to n decimals, or to n significant digits.
inline json with_decimals(double x, int n) {
  return number(fmt::format("{:.{}f}", x, n));
}
inline json with_digits(double x, int n) {
  return number(fmt::format("{:.{}g}", x, n));
}

// On one line, without the line end. Bytes that are not UTF-8 are replaced.
inline std::string in_one_line(const json &value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace meetc::app

#endif
