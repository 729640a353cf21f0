// Classes by duality. The affine dependences of n points that span d-space are a space of dimension e = n - d
// - 1, the row space of a matrix of n columns g in e-space with sum 0; the determinant of d + 1 of the points
// is, up to a common factor, the determinant of the other e columns, with the sign of the permutation. Any
// columns that span e-space and have a dependence with positive coefficients can be scaled to sum 0, and then
// belong to some points.
//   e = 0: there is no choice.
//   e = 1: numbers; both signs must occur.
//   e = 2: vectors in the plane, including zero. Their signs det(g, h) are those of vectors on six fixed lines,
//          since only the order of the lines by angle counts, and there are at most six lines.
#include "tests/decisions/flat/classes.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <unordered_set>

namespace meetc::decisions_test {
namespace {

using planar = std::array<std::int64_t, 2>;
using columns = std::vector<planar>;                                          // for e = 1 the second coordinate is 0
constexpr planar lines[] = {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 1}}; // by angle, from 0 to below pi

std::int64_t det(const planar &g, const planar &h) {
  return g[0] * h[1] - g[1] * h[0];
}

std::int64_t minor_of(const columns &g, const labels &of) {
  if (of.empty())
    return 1;
  const planar &first = g[static_cast<std::size_t>(of[0])];
  return of.size() == 1 ? first[0] : det(first, g[static_cast<std::size_t>(of[1])]);
}

labels without(int n, const labels &some) {
  labels out;
  for (int i = 0; i < n; ++i)
    if (std::ranges::find(some, i) == some.end())
      out.push_back(i);
  return out;
}

// The key of the points: for each S of d + 1 labels, sign (S, rest) det g_rest.
class dual_keys {
public:
  dual_keys(int n, int d) {
    for (const labels &s : subsets(n, d + 1)) {
      const labels rest = without(n, s);
      labels shuffle = s;
      shuffle.insert(shuffle.end(), rest.begin(), rest.end());
      const int sign = sort_labels(shuffle);
      of_.push_back({sign, rest});
    }
  }
  key operator()(const columns &g) const {
    key k = 0;
    for (std::size_t i = 0; i < of_.size(); ++i)
      k = with_sign(k, i, of_[i].first * sign_of(minor_of(g, of_[i].second)));
    return k;
  }

private:
  std::vector<std::pair<int, labels>> of_;
};

// Adds to the weights a dependence with coefficients >= 0, and > 0 at i, if there is one. If there is one at
// all, there is one of at most e + 1 columns.
bool add_dependence(const columns &g, std::size_t i, std::size_t e, std::vector<std::int64_t> &weight) {
  if (g[i] == planar{0, 0}) {
    ++weight[i];
    return true;
  }
  for (std::size_t j = 0; j < g.size(); ++j) // opposite: g_j = -r g_i, r > 0
    if (det(g[i], g[j]) == 0 && g[i][0] * g[j][0] + g[i][1] * g[j][1] < 0) {
      weight[i] += std::abs(g[j][0]) + std::abs(g[j][1]);
      weight[j] += std::abs(g[i][0]) + std::abs(g[i][1]);
      return true;
    }
  if (e == 2)
    for (std::size_t j = 0; j < g.size(); ++j)
      for (std::size_t k = 0; k < g.size(); ++k)
        if (det(g[i], g[j]) > 0 && det(g[j], g[k]) > 0 && det(g[k], g[i]) > 0) {
          weight[i] += det(g[j], g[k]);
          weight[j] += det(g[k], g[i]);
          weight[k] += det(g[i], g[j]);
          return true;
        }
  return false;
}

// The coefficients > 0 of a dependence of all columns, or nothing.
std::vector<std::int64_t> positive_dependence(const columns &g, std::size_t e) {
  std::vector<std::int64_t> weight(g.size());
  for (std::size_t i = 0; i < g.size(); ++i)
    if (weight[i] == 0 && !add_dependence(g, i, e, weight))
      return {};
  return weight;
}

// Points whose dependences are the rows of g, which has sum 0: d independent vectors of its kernel are the
// coordinates. With a basis B of columns, vector m has D = det g_B at m, and at B the values that
// Cramer's rule gives.
points points_of(const columns &g, int d) {
  const int n = static_cast<int>(g.size()), e = n - d - 1;
  labels basis;
  for (const labels &b : subsets(n, e))
    if (minor_of(g, b) != 0) {
      basis = b;
      break;
    }
  const std::int64_t scale = minor_of(g, basis);
  points x(g.size(), place{});
  std::int64_t divisor = 0;
  const labels free = without(n, basis);
  for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
    x[static_cast<std::size_t>(free[k])][k] = scale;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      labels swapped = basis;
      swapped[i] = free[k];
      x[static_cast<std::size_t>(basis[i])][k] = -minor_of(g, swapped);
    }
  }
  for (const place &p : x)
    for (const std::int64_t c : p)
      divisor = std::gcd(divisor, c);
  for (place &p : x)
    for (std::int64_t &c : p)
      c /= divisor;
  return x;
}

// For every key that such lists have, one list of columns, scaled to sum 0.
std::unordered_map<key, columns> dual_lists(int n, int d) {
  const int e = n - d - 1;
  std::unordered_map<key, columns> out;
  columns g(static_cast<std::size_t>(n));
  std::unordered_set<key> seen;
  const dual_keys key_of(n, d);
  const auto take = [&] {
    const key k = key_of(g);
    if (!seen.insert(k).second || !spans(k, n, d))
      return;
    const std::vector<std::int64_t> weight = positive_dependence(g, static_cast<std::size_t>(e));
    if (weight.empty())
      return;
    columns scaled = g;
    for (std::size_t i = 0; i < g.size(); ++i)
      for (std::int64_t &c : scaled[i])
        c *= weight[i];
    out.emplace(k, scaled);
  };
  const auto choose = [&](auto &&self, std::size_t i) -> void {
    if (i == g.size())
      return take();
    g[i] = {0, 0};
    self(self, i + 1);
    const std::size_t choices = e == 0 ? 0 : e == 1 ? 1 : std::size(lines);
    for (std::size_t l = 0; l < choices; ++l)
      for (const int sign : {1, -1}) {
        g[i] = {sign * lines[l][0], sign * lines[l][1]};
        self(self, i + 1);
      }
  };
  choose(choose, 0);
  return out;
}

} // namespace

witnesses witnesses_by_duality(int n, int d) {
  const std::unordered_map<key, columns> duals = dual_lists(n, d);
  witnesses out;
  for (const auto &[k, g] : duals) {
    if (out.contains(k))
      continue;
    points x = points_of(g, d);
    if (const key found = chirotope_of(x, d); found != k && found != negative(k, n, d))
      throw std::logic_error("the signs of some points are not those of their dual");
    for (int mirrored = 0; mirrored < 2; ++mirrored) {
      add_relabelled(out, x, d);
      for (place &p : x)
        p[0] = -p[0];
    }
  }
  // Relabelling and mirroring give only keys that the duals have, except for the other orientation of a
  // simplex.
  if (out.size() != duals.size() + (n == d + 1 ? 1 : 0))
    throw std::logic_error("the classes of the points are not those of their duals");
  return out;
}

} // namespace meetc::decisions_test
