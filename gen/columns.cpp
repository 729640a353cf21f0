#include "gen/columns.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc {

std::string in_columns(const std::vector<std::vector<std::string>> &rows, bool words_last) {
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto &row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const auto &row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out += i == 0                              ? fmt::format("{:<{}}", row[i], widths[i])
             : words_last && i + 1 == row.size() ? "  " + row[i]
                                                 : fmt::format("  {:>{}}", row[i], widths[i]);
    out += '\n';
  }
  return out;
}

} // namespace meetc
