#include "meet/app/input/option_values.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace meetc::app {

namespace {

// Whether a number is missing on either side of a comma.
bool has_hole(std::string_view text) {
  bool number = false, comma = false;
  for (const char c : text) {
    if (c == ',' && !number)
      return true;
    comma = comma || c == ',';
    number = c != ',' && (number || (c != ' ' && c != '\t'));
  }
  return comma && !number;
}

} // namespace

int threads_named(const std::string &text) {
  std::int64_t n = 0;
  if (!io::parse_integer(text, n) || n < 0 || n > max_threads)
    throw failure(fmt::format("--threads: {} is not a number from 0 to {}", io::quote(text), max_threads));
  return static_cast<int>(n);
}

int devices_named(const std::string &text) {
  constexpr int most_devices = 64;
  std::int64_t n = 0;
  if (!io::parse_integer(text, n) || n < 1 || n > most_devices)
    throw failure(fmt::format("--devices: {} is not a number from 1 to {}", io::quote(text), most_devices));
  return static_cast<int>(n);
}

double length_named(const char *option, const std::string &text) {
  const double v = numbers<1>(option, text)[0];
  if (!(v >= 0) || !std::isfinite(v))
    throw failure(fmt::format("{}: {} is not a finite length of 0 or more", option, io::quote(text)));
  return v;
}

std::vector<double> number_list(const char *option, std::string text) {
  if (has_hole(text))
    throw failure(fmt::format("{}: {} lacks a number beside a comma", option, io::quote(text)));
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<double> out;
  std::string_view rest = text;
  for (std::string_view word; !(word = io::take_word(rest)).empty();) {
    double value = 0;
    if (!io::parse_decimal(word, io::precision::float64, value))
      throw failure(fmt::format("{}: {} is not a number", option, io::quote(word)));
    out.push_back(value);
  }
  return out;
}

void read_numbers(const char *option, const std::string &text, std::span<double> to) {
  const std::vector<double> found = number_list(option, text);
  if (found.size() != to.size())
    throw failure(fmt::format("{}: {} number{} expected{}, {} given", option, to.size(), to.size() == 1 ? "" : "s",
                              to.size() == 1 ? "" : ", with commas between them", found.size()));
  std::ranges::copy(found, to.begin());
}

} // namespace meetc::app
