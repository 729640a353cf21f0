#include "gen/oracle/bodies.hpp"

#include <algorithm>

namespace meetc::oracle {
namespace {

point moved(const point &p, const point &by, const rational &times) {
  point out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = p[k] + times * by[k];
  return out;
}

rational dot(const point &a, const point &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The common denominator of all coordinates.
mpz_class denominator(const hull &a, const hull &b) {
  mpz_class out = 1;
  for (const hull *const h : {&a, &b})
    for (const point &p : *h)
      for (const rational &x : p)
        mpz_lcm(out.get_mpz_t(), out.get_mpz_t(), x.get_den_mpz_t());
  return out;
}

// The largest difference of two corners of one hull along an axis.
rational width(const hull &a) {
  rational out = 0;
  for (const point &p : a)
    for (const point &q : a)
      for (std::size_t k = 0; k < 3; ++k)
        out = std::max(out, rational(p[k] - q[k]));
  return out;
}

// Whether all points within r > 0 of p lie in the hull: p lies that far on the inner side of every plane (in the plane:
// line) through corners that has all corners on one side.
bool holds_ball(const hull &a, const point &p, const rational &r, std::size_t dimensions) {
  const auto difference = [](const point &x, const point &y) { return moved(x, y, -1); };
  bool any = false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t l = 0; l < (dimensions == 2 ? 1 : a.size()); ++l) {
        const point u = difference(a[j], a[i]), v = dimensions == 2 ? at(0, 0, 1) : difference(a[l], a[i]);
        const point n = at(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
        const rational square = dot(n, n), most = dot(n, a[i]), inwards = most - dot(n, p);
        if (square == 0 || std::any_of(a.begin(), a.end(), [&](const point &q) { return dot(n, q) > most; }))
          continue;
        any = true;
        if (inwards < 0 || inwards * inwards < r * r * square)
          return false;
      }
  return any;
}

} // namespace

bool meets_beyond(const hull &a, const hull &b, const hull &common) {
  const std::vector<point> shared = common_part(a, b);
  return std::any_of(shared.begin(), shared.end(),
                     [&](const point &p) { return common.empty() || squared_distance({p}, common) != 0; });
}

// Without pads: in units of one over the common denominator, let no width exceed d >= 1. The differences of points of a and b
// are a polytope, and a face of it lies in a plane n . x = c, where n is a product of two differences of corners, with whole
// numbers of at most 2 d^2. If 0 is inside, c is at least 1, and a translation by at most 1 / (6 d^2) along each axis does not
// pass the face. Translations that lead around 0 suffice, as the polytope is convex.
bool overlaps(const body &a, const body &b) {
  const rational reach = a.pad + b.pad;
  if (reach > 0)
    return squared_distance(a.points, b.points) < reach * reach;
  const rational unit = rational(1) / rational(denominator(a.points, b.points));
  const rational d = std::max({rational(1), rational(width(a.points) / unit), rational(width(b.points) / unit)});
  const rational step = unit / (6 * d * d);
  std::vector<point> ways = {at(1, 0), at(0, 1), at(-1, -1)};
  if (a.dimensions == 3)
    ways = {at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(-1, -1, -1)};
  return std::all_of(ways.begin(), ways.end(), [&](const point &way) {
    hull there;
    for (const point &p : b.points)
      there.push_back(moved(p, way, step));
    return squared_distance(a.points, there) == 0;
  });
}

// Pads subtract: the sum of b and a ball lies in the sum of a and a ball of the same radius if and only if b lies in a.
bool contains(const body &a, const body &b) {
  const rational more = a.pad - b.pad;
  return std::all_of(b.points.begin(), b.points.end(), [&](const point &p) {
    return more < 0 ? holds_ball(a.points, p, -more, a.dimensions) : squared_distance({p}, a.points) <= more * more;
  });
}

} // namespace meetc::oracle
