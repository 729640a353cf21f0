#include "gen/lang/read_basis.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace meetc::lang {
namespace {

constexpr std::size_t most_digits = 300; // as in an expression

// 'p/q' in lowest terms, so that equal entries have equal text. Numbers with too many digits stay as they are.
std::string reduced(const std::string &s) {
  const auto slash = std::min(s.find('/'), s.size());
  if (slash > 18 || s.size() - slash > 18)
    return s;
  const long long p = std::stoll(s.substr(0, slash)), q = slash == s.size() ? 1 : std::stoll(s.substr(slash + 1));
  const long long common = std::gcd(p, q);
  return q == common ? std::to_string(p / common) : fmt::format("{}/{}", p / common, q / common);
}

std::string rational_text(const toml_reader &in, const toml::node &node) {
  if (node.is_integer())
    return std::to_string(node.as_integer()->get());
  if (node.is_string()) {
    const std::string s = node.as_string()->get();
    if (s.size() > most_digits)
      throw spec_error(in.place(node), fmt::format("this number has more than {} digits", most_digits));
    const auto slash = s.find('/');
    const auto digits = [](const std::string &d, bool sign) {
      const std::size_t from = sign && !d.empty() && d[0] == '-' ? 1 : 0;
      return d.size() > from && d.find_first_not_of("0123456789", from) == std::string::npos;
    };
    if (slash == std::string::npos ? digits(s, true)
                                   : digits(s.substr(0, slash), true) && digits(s.substr(slash + 1), false) &&
                                         s.find_first_not_of('0', slash + 1) != std::string::npos)
      return reduced(s);
  }
  throw spec_error(in.place(node), "a metric's entry is a whole number or a 'p/q' string");
}

} // namespace

void read_basis(const toml_reader &in, const toml::table &t, algebra &out) {
  if (!t.contains("vectors"))
    throw spec_error(out.where, "algebra needs 'vectors'");
  const toml::node &names = *t.get("vectors");
  out.vectors = in.as_strings(names, "algebra.vectors");
  const std::size_t n = out.vectors.size();
  if (n == 0 || n > 8)
    throw spec_error(in.place(names), fmt::format("an algebra has 1 to 8 basis vectors, not {}", n));
  for (std::size_t i = 0; i < n; ++i) {
    need_name(out.vectors[i], in.place(names), "a basis vector");
    if (std::find(out.vectors.begin(), out.vectors.begin() + static_cast<std::ptrdiff_t>(i), out.vectors[i]) !=
        out.vectors.begin() + static_cast<std::ptrdiff_t>(i))
      throw spec_error(in.place(names), fmt::format("vector '{}' is given twice", out.vectors[i]));
  }
  if (t.contains("squares") == t.contains("metric"))
    throw spec_error(out.where, "algebra needs either 'squares' or 'metric'");
  out.metric.assign(n, std::vector<std::string>(n, "0"));
  if (const toml::node *squares = t.get("squares")) {
    const toml::array &a = in.as_array(*squares, "algebra.squares");
    if (a.size() != n)
      throw spec_error(in.place(*squares), fmt::format("{} squares for {} vectors", a.size(), n));
    for (std::size_t i = 0; i < n; ++i)
      out.metric[i][i] = rational_text(in, a[i]);
  } else {
    const toml::node &metric = *t.get("metric");
    const toml::array &rows = in.as_array(metric, "algebra.metric");
    if (rows.size() != n)
      throw spec_error(in.place(metric), fmt::format("{} rows for {} vectors", rows.size(), n));
    for (std::size_t i = 0; i < n; ++i) {
      const toml::array &row = in.as_array(rows[i], "each row of algebra.metric");
      if (row.size() != n)
        throw spec_error(in.place(rows[i]), fmt::format("{} entries for {} vectors", row.size(), n));
      for (std::size_t j = 0; j < n; ++j)
        out.metric[i][j] = rational_text(in, row[j]);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (out.metric[i][j] != out.metric[j][i])
          throw spec_error(in.place(metric),
                           fmt::format("the metric is not symmetric at row {}, column {}", i + 1, j + 1));
  }
  if (const toml::node *null = t.get("null"))
    for (const toml::node &item : in.as_array(*null, "algebra.null")) {
      const std::string name = in.as_string(item, "each item of algebra.null");
      need_name(name, in.place(item), "a null vector");
      const auto size = name.size();
      const location at = in.place(item);
      const auto file = in.file();
      const std::size_t inner = at.offset + 1;
      out.null.push_back({name, parse_expression({file, inner, inner + size}), at});
    }
}

} // namespace meetc::lang
