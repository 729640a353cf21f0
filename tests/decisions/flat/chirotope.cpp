#include "tests/decisions/flat/chirotope.hpp"

#include <algorithm>
#include <map>

namespace meetc::decisions_test {
namespace {

std::vector<labels> all_subsets(int n, int k) {
  std::vector<labels> out;
  labels l;
  const auto extend = [&](auto &&self, int from) -> void {
    if (static_cast<int>(l.size()) == k) {
      out.push_back(l);
      return;
    }
    for (int i = from; i < n; ++i) {
      l.push_back(i);
      self(self, i + 1);
      l.pop_back();
    }
  };
  extend(extend, 0);
  return out;
}

constexpr int most = 6; // labels

// Indexed by the bits of the subset.
using index_table = std::array<std::size_t, 1U << most>;
unsigned bits_of(const labels &l) {
  unsigned bits = 0;
  for (const int i : l)
    bits |= 1U << i;
  return bits;
}
std::array<index_table, most + 1> index_tables() {
  std::array<index_table, most + 1> out{};
  for (int n = 1; n <= most; ++n)
    for (int k = 0; k <= n; ++k) {
      const auto &all = subsets(n, k);
      for (std::size_t i = 0; i < all.size(); ++i)
        out[static_cast<std::size_t>(n)][bits_of(all[i])] = i;
    }
  return out;
}

} // namespace

const std::vector<labels> &subsets(int n, int k) {
  static const auto all = [] {
    std::array<std::array<std::vector<labels>, most + 1>, most + 1> out;
    for (int i = 0; i <= most; ++i)
      for (int j = 0; j <= most; ++j)
        out[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = all_subsets(i, j);
    return out;
  }();
  return all.at(static_cast<std::size_t>(n)).at(static_cast<std::size_t>(k));
}

std::size_t index_of(int n, const labels &increasing) {
  static const auto tables = index_tables();
  return tables.at(static_cast<std::size_t>(n)).at(bits_of(increasing));
}

int sort_labels(labels &l) {
  int sign = 1;
  for (std::size_t i = 0; i < l.size(); ++i)
    for (std::size_t j = i + 1; j < l.size(); ++j)
      sign *= l[i] == l[j] ? 0 : l[i] < l[j] ? 1 : -1;
  std::ranges::sort(l);
  return sign;
}

std::int64_t determinant(const points &x, const labels &of) {
  const std::size_t d = of.size() - 1;
  std::int64_t m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; // in fewer dimensions the rest is the unit matrix
  for (std::size_t i = 0; i < d; ++i)
    for (std::size_t k = 0; k < d; ++k)
      m[i][k] = x[static_cast<std::size_t>(of[i + 1])][k] - x[static_cast<std::size_t>(of[0])][k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

key chirotope_of(const points &x, int d) {
  const auto &all = subsets(static_cast<int>(x.size()), d + 1);
  key k = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    k = with_sign(k, i, sign_of(determinant(x, all[i])));
  return k;
}

key negative(key k, int n, int d) {
  key out = 0;
  for (std::size_t i = 0; i < subsets(n, d + 1).size(); ++i)
    out = with_sign(out, i, -sign_at(k, i));
  return out;
}

bool spans(key k, int n, int d) {
  for (std::size_t i = 0; i < subsets(n, d + 1).size(); ++i)
    if (sign_at(k, i) != 0)
      return true;
  return false;
}

int orientation(key k, int n, labels of) {
  const int sign = sort_labels(of);
  return sign == 0 ? 0 : sign * sign_at(k, index_of(n, of));
}

bool hulls_meet(key k, int n, int d, int m) {
  for (const labels &some : subsets(n, d + 2)) {
    // Coefficient i of the dependence of d + 2 columns (1, x) is (-1)^i times the determinant of the others.
    bool used = false, one_way = true, other_way = true;
    for (std::size_t i = 0; i < some.size(); ++i) {
      labels rest = some;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      const int sign = (i % 2 == 0 ? 1 : -1) * sign_at(k, index_of(n, rest)) * (some[i] < m ? 1 : -1);
      used = used || sign != 0;
      one_way = one_way && sign >= 0;
      other_way = other_way && sign <= 0;
    }
    if (used && (one_way || other_way))
      return true;
  }
  return false;
}

} // namespace meetc::decisions_test
