#include "tests/generated/judge/judge.hpp"

#include <array>

namespace meetc::generated_test {
namespace {

using vec = std::array<mpz_class, 3>;

vec minus(const vec &a, const vec &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
mpz_class dot(const vec &a, const vec &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
vec cross(const vec &a, const vec &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const vec &a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

// The row's number that is coordinate k of corner i of the hull. Bit k of a box's corner says whether it is the greater.
std::size_t place(shape kind, std::size_t i, std::size_t k) {
  return kind == shape::box ? 3 * (i >> k & 1) + k : 3 * i + k;
}
std::size_t corners_of(shape kind) {
  return kind == shape::box ? 8 : static_cast<std::size_t>(points_of(kind));
}

// Float32 numbers are integers times 2^-149.
std::vector<vec> corners(shape kind, const row &r) {
  std::vector<vec> out(corners_of(kind));
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out[i][k] = mpq_class(mpq_class(static_cast<double>(r[place(kind, i, k)])) << 149).get_num();
  return out;
}

// Common powers of two take time and change nothing.
void shift_out(std::vector<vec> &a, std::vector<vec> &b) {
  mp_bitcnt_t low = ~mp_bitcnt_t{0};
  const auto each = [&](auto &&f) {
    for (auto *points : {&a, &b})
      for (vec &p : *points)
        for (mpz_class &c : p)
          if (c != 0)
            f(c);
  };
  each([&](const mpz_class &c) { low = std::min(low, mpz_scan1(c.get_mpz_t(), 0)); });
  each([&](mpz_class &c) { c >>= low; });
}

// Whether the projections of the two hulls on the axis are strictly apart.
bool apart(const vec &axis, const std::vector<vec> &a, const std::vector<vec> &b) {
  const auto range = [&](const std::vector<vec> &points) {
    mpz_class low = dot(axis, points[0]), high = low;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const mpz_class d = dot(axis, points[i]);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return std::pair(low, high);
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return high_a < low_b || high_b < low_a;
}

} // namespace

oracle::hull hull_of(shape kind, const row &r) {
  oracle::hull out;
  for (std::size_t i = 0; i < corners_of(kind); ++i)
    out.push_back(oracle::at(static_cast<double>(r[place(kind, i, 0)]), static_cast<double>(r[place(kind, i, 1)]),
                             static_cast<double>(r[place(kind, i, 2)])));
  return out;
}
mpq_class pad_of(shape kind, const row &r) {
  return padded(kind) ? mpq_class(static_cast<double>(r[3])) : mpq_class(0);
}

bool touching(shape a, const row &x, shape b, const row &y, bool surface) {
  return oracle::touches(hull_of(a, x), pad_of(a, x), hull_of(b, y), pad_of(b, y),
                         surface ? oracle::touch_mode::surface : oracle::touch_mode::solid);
}

bool touching_by_axes(shape a, const row &x, shape b, const row &y) {
  std::vector<vec> p = corners(a, x), q = corners(b, y);
  shift_out(p, q);
  std::vector<vec> edges; // the non-zero ones
  for (const auto *points : {&p, &q})
    for (std::size_t i = 0; i < points->size(); ++i)
      for (std::size_t j = i + 1; j < points->size(); ++j)
        if (const vec e = minus((*points)[j], (*points)[i]); !is_zero(e))
          edges.push_back(e);
  const vec between = minus(q[0], p[0]);
  if (edges.empty())
    return is_zero(between);
  vec normal{};
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j)
      if (const vec across = cross(edges[i], edges[j]); !is_zero(across)) {
        if (apart(across, p, q))
          return false;
        normal = across;
      }
  if (is_zero(normal)) // all edges are parallel, so there are one or two lines
    return is_zero(cross(between, edges[0])) && !apart(edges[0], p, q);
  for (const vec &e : edges)
    if (const vec across = cross(normal, e); !is_zero(across) && apart(across, p, q))
      return false; // facet normals where everything is flat, and valid separations in any case
  return true;
}

} // namespace meetc::generated_test
