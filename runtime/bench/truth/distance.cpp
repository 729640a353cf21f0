#include "meet/bench/truth/distance.hpp"

#include "meet/bench/baselines/vectors.hpp"
#include "meetc/number/double_double.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace meetc::bench {

namespace {

using real = double_words<MEETC_FUSES>; // a call of the C library's fma() would take most of the time
constexpr int most_points = 4;

using vec = baselines::vec<real>;

bool less(const real &x, const real &y) {
  return x.hi < y.hi || (x.hi == y.hi && x.lo < y.lo);
}
real least_of(const real &x, const real &y) {
  return less(y, x) ? y : x;
}

// x / y for y > 0.
real quotient(const real &x, const real &y) {
  const double q = x.hi / y.hi;
  return two_sum<MEETC_FUSES>(q, (x - y * q).hi / y.hi);
}

// The square root of x, or 0 where x is not positive: one step of Newton's method from that of the double.
real root(const real &x) {
  if (!(x.hi > 0))
    return real(0.0);
  const double s = std::sqrt(x.hi);
  return two_sum<MEETC_FUSES>(s, (x - two_product<MEETC_FUSES>(s, s)).hi / (2 * s));
}

// An element, relative to an origin, with all numbers multiplied by a power of two that brings them near 1.
struct padded_hull {
  std::array<vec, most_points> points{};
  int count = 0;
  real pad{0.0};
};

double coordinate(const kind_info &kind, const float *row, int point, int axis) {
  const int field = kind.hull_fields[3 * point + axis];
  return field < 0 ? 0.0 : static_cast<double>(row[field]);
}

padded_hull hull_of(const kind_info &kind, const float *row, const std::array<double, 3> &origin, double scale) {
  padded_hull h;
  h.count = kind.hull;
  const auto from_origin = [&](int p, int k) {
    const real d = two_sum<MEETC_FUSES>(coordinate(kind, row, p, k), -origin[static_cast<std::size_t>(k)]);
    return real(d.hi * scale, d.lo * scale);
  };
  for (int p = 0; p < h.count; ++p)
    h.points[static_cast<std::size_t>(p)] = {from_origin(p, 0), from_origin(p, 1), from_origin(p, 2)};
  if (kind.pad >= 0)
    h.pad = real(static_cast<double>(row[kind.pad]) * scale);
  return h;
}

// The points of the Minkowski difference, of which there are `count`.
struct differences {
  std::array<vec, std::size_t{most_points} * most_points> points{};
  std::size_t count = 0;
  differences(const padded_hull &a, const padded_hull &b) {
    for (int i = 0; i < a.count; ++i)
      for (int j = 0; j < b.count; ++j)
        points.at(count++) = b.points.at(static_cast<std::size_t>(j)) - a.points.at(static_cast<std::size_t>(i));
  }
};

const real nothing(HUGE_VAL);

// The squared distance of the origin from the segment p q, where its foot lies between them.
real to_segment(const vec &p, const vec &q) {
  const vec d = q - p;
  const real length = dot(d, d), along = -dot(p, d);
  if (!(along.hi > 0) || !less(along, length))
    return nothing;
  const vec n = cross(p, d);
  return quotient(dot(n, n), length);
}

// The same for the triangle p q r.
real to_triangle(const vec &p, const vec &q, const vec &r) {
  const vec n = cross(q - p, r - p);
  const real area = dot(n, n);
  if (!(area.hi > 0) || dot(cross(p, q), n).hi < 0 || dot(cross(q, r), n).hi < 0 || dot(cross(r, p), n).hi < 0)
    return nothing;
  const real h = dot(p, n);
  return quotient(h * h, area);
}

// The distance of two hulls that do not touch.
real distance(const differences &d) {
  real least = nothing;
  for (std::size_t i = 0; i < d.count; ++i) {
    least = least_of(least, dot(d.points.at(i), d.points.at(i)));
    for (std::size_t j = i + 1; j < d.count; ++j) {
      least = least_of(least, to_segment(d.points.at(i), d.points.at(j)));
      for (std::size_t k = j + 1; k < d.count; ++k)
        least = least_of(least, to_triangle(d.points.at(i), d.points.at(j), d.points.at(k)));
    }
  }
  return root(least);
}

// How far the hulls go beyond each other along n or along -n, whichever is less; 0 where they do not.
real overlap(const differences &d, const vec &n) {
  const real length = root(dot(n, n));
  if (!(length.hi > 0))
    return nothing;
  real forth = -nothing, back = -nothing;
  for (std::size_t i = 0; i < d.count; ++i) {
    const real h = dot(d.points.at(i), n);
    forth = less(forth, h) ? h : forth;
    back = less(back, -h) ? -h : back;
  }
  const real both = least_of(forth, back);
  return both.hi > 0 ? quotient(both, length) : real(0.0);
}

// The normal of two edges; zero where they are so nearly parallel that only rounding would be left of it.
vec normal(const vec &e, const vec &f) {
  constexpr double parallel = 0x1p-160;
  const vec n = cross(e, f);
  const real zero(0.0);
  return dot(n, n).hi > parallel * dot(e, e).hi * dot(f, f).hi ? n : vec{zero, zero, zero};
}

// How far two hulls that touch reach into each other; 0 for hulls that do not touch. If all differences lie on one line,
// the hulls part at right angles to it.
real depth(const differences &d) {
  real least = nothing;
  for (std::size_t i = 0; i < d.count; ++i)
    for (std::size_t j = i + 1; j < d.count; ++j)
      for (std::size_t k = j + 1; k < d.count; ++k)
        least = least_of(least, overlap(d, normal(d.points.at(j) - d.points.at(i), d.points.at(k) - d.points.at(i))));
  return std::isfinite(least.hi) ? least : real(0.0);
}

// How far the farthest point of `inner` lies from the one point of `outer`.
real farthest(const padded_hull &outer, const padded_hull &inner) {
  real most(0.0);
  for (int i = 0; i < inner.count; ++i) {
    const vec d = inner.points.at(static_cast<std::size_t>(i)) - outer.points[0];
    most = -least_of(-most, -dot(d, d));
  }
  return root(most);
}

bool is_surface(const kind_info &kind, bool surfaces) {
  return surfaces && kind.pad >= 0 && kind.hull == 1;
}

} // namespace

bool has_distances(const predicate_info &p) {
  const auto known = [](const kind_info &kind) { return kind.hull >= 1 && kind.hull <= most_points; };
  return known(*p.a) && known(*p.b);
}

double distance_from_change(const predicate_info &of, const float *row_a, const float *row_b, bool touch) {
  const kind_info &kind_a = *of.a, &kind_b = *of.b;
  const bool surfaces = std::string_view(of.mode) == "surface";
  std::array<double, 3> origin{};
  for (int k = 0; k < 3; ++k)
    origin[static_cast<std::size_t>(k)] = coordinate(kind_a, row_a, 0, k);
  double largest = 0;
  for (const auto &[kind, row] : {std::pair{&kind_a, row_a}, std::pair{&kind_b, row_b}}) {
    for (int p = 0; p < kind->hull; ++p)
      for (int k = 0; k < 3; ++k)
        largest = std::max(largest, std::fabs(coordinate(*kind, row, p, k) - origin[static_cast<std::size_t>(k)]));
    if (kind->pad >= 0)
      largest = std::max(largest, static_cast<double>(row[kind->pad]));
  }
  if (!(largest > 0))
    return 0;
  const double scale = std::ldexp(1.0, -std::ilogb(largest));
  const padded_hull a = hull_of(kind_a, row_a, origin, scale), b = hull_of(kind_b, row_b, origin, scale);
  const differences d(a, b);
  const real pads = a.pad + b.pad;
  // The length that one surface lacks, or has too much, for enclosing the other element, if it can.
  const std::array<std::pair<bool, real>, 2> enclosing{
      std::pair{is_surface(kind_a, surfaces) && less(b.pad, a.pad), farthest(a, b) - (a.pad - b.pad)},
      std::pair{is_surface(kind_b, surfaces) && less(a.pad, b.pad), farthest(b, a) - (b.pad - a.pad)}};
  real change = distance(d) - pads;
  if (!touch) {
    for (const auto &[can, lack] : enclosing)
      if (can && less(change, -lack))
        change = -lack;
  } else {
    const real inside = depth(d);
    change = inside.hi > 0 ? pads + inside : -change;
    for (const auto &[can, lack] : enclosing)
      if (can)
        change = least_of(change, lack);
  }
  return std::max(change.hi, 0.0) / scale;
}

double ulp_of_pair(const predicate_info &p, const float *row_a, const float *row_b) {
  float largest = 0;
  for (const auto &[kind, row] : {std::pair{p.a, row_a}, std::pair{p.b, row_b}})
    for (int f = 0; f < kind->fields; ++f)
      largest = std::max(largest, std::fabs(row[f]));
  return static_cast<double>(std::nextafterf(largest, std::numeric_limits<float>::infinity())) -
         static_cast<double>(largest);
}

} // namespace meetc::bench
