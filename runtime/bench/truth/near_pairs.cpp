#include "meet/bench/truth/near_pairs.hpp"

#include "meet/bench/truth/distance.hpp"
#include "meet/bench/truth/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace meetc::bench {

namespace {

using vec = std::array<double, 3>;

vec operator+(const vec &a, const vec &b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
vec operator*(double s, const vec &a) {
  return {s * a[0], s * a[1], s * a[2]};
}
double dot(const vec &a, const vec &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A vector of integers with an integer length.
struct direction {
  vec v;
  int length;
};

direction random_direction(numbers &from) {
  static constexpr std::array<std::array<int, 4>, 8> all{{{1, 0, 0, 1},
                                                          {0, 3, 4, 5},
                                                          {1, 2, 2, 3},
                                                          {2, 3, 6, 7},
                                                          {1, 4, 8, 9},
                                                          {4, 4, 7, 9},
                                                          {2, 6, 9, 11},
                                                          {6, 6, 7, 11}}};
  const std::array<int, 4> &u = all.at(static_cast<std::size_t>(from.below(static_cast<int>(all.size()))));
  std::array<std::size_t, 3> order{0, 1, 2};
  for (std::size_t i = 2; i > 0; --i)
    std::swap(order.at(i), order.at(static_cast<std::size_t>(from.below(static_cast<int>(i) + 1))));
  direction d{{}, u[3]};
  for (std::size_t k = 0; k < 3; ++k)
    d.v.at(order.at(k)) = (from.below(2) ? 1 : -1) * u.at(k);
  return d;
}

// A point of a lattice in the plane through the origin at right angles to u; its coordinates are multiples of 2^-10.
vec in_plane(numbers &from, const direction &u) {
  constexpr double step = 0x1p-10;
  const int most = std::max(1, 360 / u.length);
  const auto some = [&] { return step * from.whole(most); };
  const double i = some(), j = some(), k = some(); // drawn in this order
  return i * vec{u.v[1], -u.v[0], 0} + j * vec{u.v[2], 0, -u.v[0]} + k * vec{0, u.v[2], -u.v[1]};
}

vec anywhere(numbers &from) {
  return {static_cast<double>(from.place()), static_cast<double>(from.place()), static_cast<double>(from.place())};
}

// An element before its numbers are rounded.
struct shape {
  std::vector<vec> points;
  double pad = 0;
  bool movable = false; // by a small length: it has a point at the origin
};

shape random_shape(numbers &from, const kind_info &kind) {
  shape s;
  for (int p = 0; p < kind.hull; ++p)
    s.points.push_back(anywhere(from));
  if (kind.pad >= 0)
    s.pad = std::fabs(static_cast<double>(from.place())) / 2;
  return s;
}

// Touches the plane at the origin, and lies on the side to which `side` * u points.
shape touching_shape(numbers &from, const kind_info &kind, const direction &u, int side) {
  shape s;
  const auto hull = static_cast<std::size_t>(kind.hull);
  s.points.resize(hull);
  const int part = 1 + from.below(std::min(kind.hull, 3));
  std::array<vec, 3> on_plane{};
  if (part == 2) {
    on_plane[0] = in_plane(from, u);
    on_plane[1] = -std::ldexp(1.0, from.whole(1)) * on_plane[0];
  } else if (part == 3) {
    on_plane[0] = in_plane(from, u), on_plane[1] = in_plane(from, u);
    on_plane[2] = -1.0 * (on_plane[0] + on_plane[1]);
  }
  const auto first = static_cast<std::size_t>(from.below(kind.hull));
  for (std::size_t p = 0; p < hull; ++p) {
    vec &at = s.points.at((first + p) % hull);
    if (p < static_cast<std::size_t>(part)) {
      at = on_plane.at(p);
      continue;
    }
    at = anywhere(from);
    if (dot(at, u.v) * side < 0)
      at = -1.0 * at;
  }
  s.movable = part == 1;
  if (kind.pad >= 0) {
    const int steps = 1 + from.below(512 / u.length);
    s.pad = 0x1p-10 * steps * u.length;
    for (vec &at : s.points)
      at = at + (side * 0x1p-10 * steps) * u.v;
    s.movable = false;
  }
  return s;
}

void move(shape &s, const vec &by) {
  for (vec &at : s.points)
    at = at + by;
}

// A point of `inner`, which lies within the ball, touches its surface at the origin from inside.
shape enclosed_shape(numbers &from, const kind_info &kind, const shape &ball) {
  shape s;
  if (kind.pad >= 0) { // a smaller ball that touches at the origin
    const double share = std::ldexp(1.0, -1 - from.below(3));
    s.pad = share * ball.pad;
    s.points.assign(static_cast<std::size_t>(kind.hull), share * ball.points[0]);
    return s;
  }
  const auto first = static_cast<std::size_t>(from.below(kind.hull));
  s.points.resize(static_cast<std::size_t>(kind.hull));
  for (std::size_t p = 1; p < s.points.size(); ++p)
    s.points.at((first + p) % s.points.size()) = ball.points[0] + (ball.pad / 4) * anywhere(from);
  s.movable = true;
  return s;
}

struct two_shapes {
  shape a, b;
};

two_shapes near_shapes(numbers &from, const predicate_info &p, const pair_difficulty &d) {
  const direction u = random_direction(from);
  two_shapes s{touching_shape(from, *p.a, u, -1), {}};
  const bool encloses = std::string_view(p.mode) == "surface" && p.a->pad >= 0 && p.a->hull == 1 && from.below(4) == 0;
  s.b = encloses ? enclosed_shape(from, *p.b, s.a) : touching_shape(from, *p.b, u, 1);
  const int bits = d.bits_from + from.below(d.bits_to - d.bits_from + 1);
  // 2^-bits of a unit, along u / |u| but for a factor from 1 to 2; the product is exact.
  const double length = (from.below(2) ? 1 : -1) * std::ldexp(1.0, -bits - std::ilogb(u.length));
  if (s.b.movable || !s.a.movable)
    move(s.b, length * u.v);
  else
    move(s.a, -length * u.v);
  return s;
}

std::vector<float> row_of(numbers &from, const kind_info &kind, const shape &s, const pair_difficulty &d) {
  std::vector<float> row(static_cast<std::size_t>(kind.fields));
  for (float &field : row)
    field = from.place(); // for what is neither a coordinate nor the pad
  for (int p = 0; p < kind.hull; ++p)
    for (int k = 0; k < 3; ++k)
      if (const int field = kind.hull_fields[3 * p + k]; field >= 0)
        row.at(static_cast<std::size_t>(field)) = static_cast<float>(
            std::ldexp(s.points.at(static_cast<std::size_t>(p)).at(static_cast<std::size_t>(k)) + d.offset, d.scale));
  if (kind.pad >= 0)
    row.at(static_cast<std::size_t>(kind.pad)) = static_cast<float>(std::ldexp(s.pad, d.scale));
  return row;
}

bool boxes_touch(const kind_info &kind_a, const float *a, const kind_info &kind_b, const float *b) {
  std::array<float, 3> low_a{}, high_a{}, low_b{}, high_b{};
  kind_a.box(a, low_a.data(), high_a.data());
  kind_b.box(b, low_b.data(), high_b.data());
  for (std::size_t k = 0; k < 3; ++k)
    if (high_a.at(k) < low_b.at(k) || high_b.at(k) < low_a.at(k))
      return false;
  return true;
}

} // namespace

bool can_make_pairs(const predicate_info &p) {
  return has_distances(p);
}

element_pairs make_pairs(const predicate_info &p, std::size_t n, const pair_difficulty &d, std::uint64_t seed) {
  if (!can_make_pairs(p) || d.bits_to < d.bits_from)
    throw std::invalid_argument("pairs cannot be made: a hull is not known, or no bits are allowed");
  element_pairs out{&p, {}, {}, n};
  out.a.reserve(n * static_cast<std::size_t>(p.a->fields));
  out.b.reserve(n * static_cast<std::size_t>(p.b->fields));
  numbers from(seed);
  constexpr int most_attempts = 64; // boxes of points, say, never touch
  for (std::size_t made = 0, attempts = 0; made < n;) {
    const two_shapes s =
        d.near ? near_shapes(from, p, d) : two_shapes{random_shape(from, *p.a), random_shape(from, *p.b)};
    const std::vector<float> a = row_of(from, *p.a, s.a, d), b = row_of(from, *p.b, s.b, d);
    if (!d.near && ++attempts < most_attempts && !boxes_touch(*p.a, a.data(), *p.b, b.data()))
      continue;
    out.a.insert(out.a.end(), a.begin(), a.end());
    out.b.insert(out.b.end(), b.begin(), b.end());
    ++made, attempts = 0;
  }
  return out;
}

} // namespace meetc::bench
