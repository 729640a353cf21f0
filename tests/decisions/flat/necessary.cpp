#include "tests/decisions/flat/necessary.hpp"

#include <algorithm>

namespace meetc::decisions_test {
namespace {

constexpr std::size_t none = ~std::size_t{0};

struct product {
  int sign;
  std::size_t first, second; // indices of determinants; there may be no second one
};
using identity = std::vector<product>; // their sum is zero

labels joined(const labels &a, int b, int c) {
  labels out = a;
  out.push_back(b);
  out.push_back(c);
  return out;
}

// sign * [u][v], with labels in any order that are different within one list.
product of(int n, int sign, labels u, labels v) {
  sign *= sort_labels(u) * sort_labels(v);
  return {sign, index_of(n, u), index_of(n, v)};
}

std::vector<identity> identities(int n, int d) {
  std::vector<identity> out;
  for (const labels &some : subsets(n, d + 2)) {
    identity terms;
    for (std::size_t i = 0; i < some.size(); ++i) {
      labels rest = some;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      terms.push_back({i % 2 == 0 ? 1 : -1, index_of(n, rest), none});
    }
    out.push_back(terms);
  }
  if (d == 0)
    return out;
  for (const labels &common : subsets(n, d - 1)) {
    labels others;
    for (int i = 0; i < n; ++i)
      if (std::ranges::find(common, i) == common.end())
        others.push_back(i);
    for (const labels &four : subsets(static_cast<int>(others.size()), 4)) {
      int x[4];
      for (std::size_t i = 0; i < 4; ++i)
        x[i] = others[static_cast<std::size_t>(four[i])];
      out.push_back({of(n, 1, joined(common, x[0], x[1]), joined(common, x[2], x[3])),
                     of(n, -1, joined(common, x[0], x[2]), joined(common, x[1], x[3])),
                     of(n, 1, joined(common, x[0], x[3]), joined(common, x[1], x[2]))});
    }
  }
  return out;
}

} // namespace

std::vector<key> possible_keys(int n, int d) {
  const std::size_t count = subsets(n, d + 1).size();
  // Each identity is tested as soon as its last determinant has a sign.
  std::vector<std::vector<identity>> at(count);
  for (identity &terms : identities(n, d)) {
    std::size_t last = 0;
    for (const product &t : terms)
      last = std::max({last, t.first, t.second == none ? 0 : t.second});
    at[last].push_back(std::move(terms));
  }
  std::vector<int> sign(count);
  const auto contradicted = [&](const identity &terms) {
    bool up = false, down = false;
    for (const product &t : terms) {
      const int s = t.sign * sign[t.first] * (t.second == none ? 1 : sign[t.second]);
      up = up || s > 0;
      down = down || s < 0;
    }
    return up != down;
  };
  std::vector<key> out;
  const auto choose = [&](auto &&self, std::size_t i, key k) -> void {
    if (i == count) {
      if (spans(k, n, d))
        out.push_back(k);
      return;
    }
    for (sign[i] = -1; sign[i] <= 1; ++sign[i])
      if (std::ranges::none_of(at[i], contradicted))
        self(self, i + 1, with_sign(k, i, sign[i]));
  };
  choose(choose, 0, 0);
  std::ranges::sort(out);
  return out;
}

} // namespace meetc::decisions_test
