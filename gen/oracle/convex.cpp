#include "gen/oracle/convex.hpp"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace meetc::oracle {
namespace {

point minus(const point &a, const point &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
rational dot(const point &a, const point &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void require_points(const hull &a) {
  if (a.empty())
    throw std::invalid_argument("the hull of no point");
}

// Solves g t = h by elimination; nothing when g is singular. g is a Gram matrix, at most 3 by 3 when regular.
std::optional<std::vector<rational>> solve(std::vector<std::vector<rational>> g, std::vector<rational> h) {
  const std::size_t n = h.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && g[pivot][k] == 0)
      ++pivot;
    if (pivot == n)
      return std::nullopt;
    std::swap(g[k], g[pivot]);
    std::swap(h[k], h[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || g[i][k] == 0)
        continue;
      const rational f = g[i][k] / g[k][k];
      for (std::size_t j = k; j < n; ++j)
        g[i][j] -= f * g[k][j];
      h[i] -= f * h[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    h[k] /= g[k][k];
  return h;
}

hull subset(const hull &a, unsigned mask) {
  hull s;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (mask >> i & 1)
      s.push_back(a[i]);
  return s;
}

// The weights of the points of one side must not be negative; the first point's is what is left to 1.
bool weights_feasible(const std::vector<rational> &t, std::size_t begin, std::size_t end) {
  rational first = 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (t[i] < 0)
      return false;
    first -= t[i];
  }
  return first >= 0;
}

// w = x - y, with x and y the nearest points of the flats through the points of a and of b: a stationary
// point of |x - y|². Nothing when x and y are not unique, or when one lies outside its hull.
std::optional<point> stationary(const hull &a, const hull &b) {
  std::vector<point> directions;
  for (std::size_t i = 1; i < a.size(); ++i)
    directions.push_back(minus(a[i], a[0]));
  for (std::size_t i = 1; i < b.size(); ++i)
    directions.push_back(minus(b[0], b[i]));
  const std::size_t n = directions.size();
  if (n > 3)
    return std::nullopt; // more than three directions of space are dependent
  point w = minus(a[0], b[0]);
  std::vector<std::vector<rational>> gram(n, std::vector<rational>(n));
  std::vector<rational> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      gram[i][j] = dot(directions[i], directions[j]);
    right[i] = -dot(directions[i], w);
  }
  const auto t = solve(std::move(gram), std::move(right));
  if (!t || !weights_feasible(*t, 0, a.size() - 1) || !weights_feasible(*t, a.size() - 1, n))
    return std::nullopt;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      w[k] += (*t)[i] * directions[i][k];
  return w;
}

// The optimality conditions of the whole programme: w is a difference of points of the hulls, and no
// difference of corners lies further back along w. Then |w| is the distance: the slab between two planes
// across w parts the hulls.
bool optimal(const point &w, const hull &a, const hull &b) {
  const rational square = dot(w, w);
  for (const point &p : a)
    for (const point &q : b)
      if (dot(w, minus(p, q)) < square)
        return false;
  return true;
}

} // namespace

point at(const rational &x, const rational &y, const rational &z) {
  return {x, y, z};
}

// Why every subset of corners is enough, and singular ones may be skipped: the nearest points' weights form a
// polytope (their difference w is unique). At a corner of that polytope the corners of a and b in use have
// independent directions, so their programme is regular, and its only stationary point is this one.
rational squared_distance(const hull &a, const hull &b) {
  require_points(a);
  require_points(b);
  if (a.size() > 16 || b.size() > 16)
    throw std::invalid_argument("the oracle tries every subset of corners: 16 points are too many already");
  for (unsigned i = 1; i < 1U << a.size(); ++i)
    for (unsigned j = 1; j < 1U << b.size(); ++j) {
      const auto w = stationary(subset(a, i), subset(b, j));
      if (w && optimal(*w, a, b))
        return dot(*w, *w);
    }
  throw std::logic_error("two hulls without a distance"); // excluded by the argument above
}

rational max_squared_distance(const point &p, const hull &a) {
  require_points(a);
  rational most = 0;
  for (const point &q : a) {
    const point d = minus(p, q);
    const rational square = dot(d, d);
    if (square > most)
      most = square;
  }
  return most;
}

bool touches(const hull &a, const rational &pad_a, const hull &b, const rational &pad_b, touch_mode mode) {
  if (pad_a < 0 || pad_b < 0)
    throw std::invalid_argument("a negative pad");
  const bool surfaces = mode == touch_mode::surface;
  if (surfaces && ((pad_a > 0 && a.size() != 1) || (pad_b > 0 && b.size() != 1)))
    throw std::invalid_argument("the surface of a padded hull is defined for one point only");
  const rational square = squared_distance(a, b), sum = pad_a + pad_b, difference = pad_a - pad_b;
  if (square > sum * sum)
    return false; // apart, in either mode
  if (!surfaces || sum == 0)
    return true;
  if (pad_a > 0 && pad_b > 0)
    return difference * difference <= square;
  const point &centre = pad_a > 0 ? a[0] : b[0];
  return sum * sum <= max_squared_distance(centre, pad_a > 0 ? b : a);
}

} // namespace meetc::oracle
