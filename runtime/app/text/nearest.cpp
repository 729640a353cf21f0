#include "meet/app/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace meetc::app {

namespace {

// Levenshtein's: letters inserted, left out or changed.
std::size_t distance(std::string_view x, std::string_view y) {
  std::vector<std::size_t> row(y.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= x.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= y.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (x[i - 1] == y[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

} // namespace

std::string nearest(std::string_view name, const std::vector<std::string> &known) {
  const std::string *best = nullptr;
  std::size_t least = name.size() / 2;
  for (const std::string &other : known)
    if (const std::size_t d = distance(name, other); d < least) {
      least = d;
      best = &other;
    }
  return best ? fmt::format("; did you mean '{}'?", *best) : "";
}

} // namespace meetc::app
