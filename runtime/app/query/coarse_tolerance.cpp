#include "meet/app/query/coarse_tolerance.hpp"

#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace meetc::app {

namespace {

// A pair takes some 10 ns of one core if nearly all pairs touch. Pairs that share another corner come on top of these.
constexpr std::uint64_t many_pairs = 100'000'000;

using place = std::array<double, 3>;

std::vector<place> first_points(const io::element_set &set, double grid) {
  std::vector<place> out(set.elements);
  std::vector<float> row(static_cast<std::size_t>(set.kind->fields));
  for (std::size_t i = 0; i < out.size(); ++i) {
    set.row(i, row.data());
    for (std::size_t k = 0; k < 3; ++k)
      out[i][k] = std::nearbyint(static_cast<double>(row[k]) / grid);
  }
  std::sort(out.begin(), out.end());
  return out;
}

} // namespace

std::uint64_t pairs_at_one_point(const io::element_set &a, const io::element_set &b, double grid,
                                 std::uint64_t enough) {
  const std::vector<place> x = first_points(a, grid), y = first_points(b, grid);
  std::uint64_t pairs = 0;
  for (auto i = x.begin(), j = y.begin(); i != x.end() && j != y.end() && pairs < enough;) {
    if (*i < *j) {
      i = std::lower_bound(i, x.end(), *j);
      continue;
    }
    if (*j < *i) {
      j = std::lower_bound(j, y.end(), *i);
      continue;
    }
    const auto after_i = std::upper_bound(i, x.end(), *i), after_j = std::upper_bound(j, y.end(), *j);
    pairs += static_cast<std::uint64_t>(after_i - i) * static_cast<std::uint64_t>(after_j - j);
    i = after_i, j = after_j;
  }
  return pairs;
}

std::string tolerance_warning(const io::element_set &a, const io::element_set &b, const query &q) {
  if (q.grid == 0 || q.any || a.elements == 0 || b.elements < many_pairs / a.elements)
    return {};
  if (pairs_at_one_point(a, b, q.grid, many_pairs) < many_pairs)
    return {};
  return fmt::format(
      "warning: --tolerance {} rounds numbers to multiples of 2^{}, where more than {} pairs have a corner in "
      "common; finding them all takes long",
      q.tolerance, std::ilogb(q.grid), grouped(many_pairs));
}

} // namespace meetc::app
