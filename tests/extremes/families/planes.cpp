// Families in which points lie on, or almost on, a plane or a line that float arithmetic cannot see.
#include "tests/extremes/families/families.hpp"

#include <algorithm>
#include <cmath>

namespace meetc::extremes_test {
namespace {

using vec = std::array<long, 3>;
vec sum(const vec &a, const vec &b, long k = 1) {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

void append(row &r, const vec &p) {
  for (const long c : p)
    r.push_back(static_cast<float>(c));
}

// Rows u, v, w of determinant 1 with entries up to 2^21 or, one time in four, the known ones in another
// order.
struct basis {
  vec u, v, w;
};
basis unimodular(random_numbers &random) {
  integer_rows m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (random.one_in(4)) {
    m = known_rows;
  } else {
    const long most = 1L << random.integer(6, 21);
    for (int step = 0; step < 60; ++step) { // row operations keep the determinant
      const int i = random.integer(0, 2), j = (i + random.integer(1, 2)) % 3, k = random.integer(-3, 3);
      bool fits = true;
      for (int c = 0; c < 3; ++c)
        fits = fits && std::abs(m.v[i][c] + k * m.v[j][c]) <= most;
      for (int c = 0; c < 3 && fits; ++c)
        m.v[i][c] += k * m.v[j][c];
    }
  }
  basis out{};
  const int rows = random.integer(0, 2), columns = random.integer(0, 2); // even permutations
  for (int c = 0; c < 3; ++c) {
    const auto to = static_cast<std::size_t>((c + columns) % 3);
    out.u[to] = m.v[rows][c];
    out.v[to] = m.v[(rows + 1) % 3][c];
    out.w[to] = m.v[(rows + 2) % 3][c];
  }
  return out;
}

// k w plus multiples of u and v, about within the triangle 0, u, v: of determinant k with u and v.
vec on_level(const basis &m, long k, random_numbers &random) {
  const auto cross = [](const vec &a, const vec &b, std::size_t i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    return static_cast<double>(a[j]) * static_cast<double>(b[l]) -
           static_cast<double>(a[l]) * static_cast<double>(b[j]);
  };
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(cross(m.u, m.v, i)) > std::abs(cross(m.u, m.v, axis)))
      axis = i;
  const double area = cross(m.u, m.v, axis);
  const vec p = {k * m.w[0], k * m.w[1], k * m.w[2]};
  const long s = std::lround(std::floor(cross(p, m.v, axis) / area)),
             t = std::lround(std::floor(cross(m.u, p, axis) / area));
  vec out = sum(sum(p, m.u, -s), m.v, -t);
  if (random.one_in(4)) // the other half of the parallelogram, or a neighbour
    out = sum(out, random.one_in(2) ? m.u : m.v, random.integer(-1, 1));
  return out;
}

// Tiny or zero, so that a padded operand is almost a point.
float small_radius(random_numbers &random, float step) {
  return random.one_in(2) ? 0 : step * static_cast<float>(random.integer(0, 3));
}

void finish(shape kind, row &r, random_numbers &random, float step) {
  if (padded(kind))
    r.push_back(small_radius(random, step));
}

} // namespace

pair_of_rows determinant_one(shape a, shape b, random_numbers &random) {
  const basis m = unimodular(random);
  const auto level = [&] { return on_level(m, random.integer(-1, 1), random); };
  // The larger body lies in the plane of u and v; the other's corners are a step above, below or in it.
  const bool swapped = corners(a) < corners(b);
  const shape base = swapped ? b : a, other = swapped ? a : b;
  std::vector<vec> in_plane = {{}, m.u, m.v}, beside = {level(), level(), level()};
  if (base == shape::segment && random.one_in(2)) { // diagonals, crossing a step apart
    in_plane = {{}, sum(m.u, m.v)};
    beside = {m.u, sum(m.v, level())};
  } else if (base == shape::segment) {
    beside[0] = m.v;
  } else if (corners(other) > 1 && random.one_in(2)) { // an edge across
    beside[0] = on_level(m, random.integer(1, 5), random);
    beside[1] = on_level(m, -random.integer(1, 5), random);
  }
  vec shift{};
  if (random.one_in(2))
    for (long &c : shift)
      c = random.integer(-(1 << 20), 1 << 20);
  pair_of_rows p;
  row &x = swapped ? p.b : p.a, &y = swapped ? p.a : p.b;
  for (std::size_t i = 0; i < corners(base); ++i)
    append(x, sum(in_plane[i], shift));
  for (std::size_t i = 0; i < corners(other); ++i)
    append(y, sum(beside[i], shift));
  finish(base, x, random, 1);
  finish(other, y, random, 1);
  return p;
}

pair_of_rows kettner(shape a, shape b, random_numbers &random) {
  const kettner_line &line = kettner_lines[random.one_in(8) ? 2 : random.integer(0, 1)]; // the last is slow
  // The grid's plane: z = 0, z = x or z = -y, in any order of axes.
  const int plane = random.integer(0, 2), turn = random.integer(0, 2);
  const auto at = [&](float x, float y, float lift) {
    const float v[3] = {x, y, (plane == 0 ? 0 : plane == 1 ? x : -y) + lift};
    const auto k = static_cast<std::size_t>(turn);
    return std::array<float, 3>{v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
  };
  const auto on_grid = [&] {
    const int i = random.integer(0, 255), j = random.one_in(3) ? i : std::clamp(i + random.integer(-3, 3), 0, 255);
    return at(line.base + static_cast<float>(i) * line.step, line.base + static_cast<float>(j) * line.step, 0);
  };
  const auto lift = [&] { return random.one_in(2) ? 0.0F : 4.0F; };
  // The points lie on one side of the grid, as in the original, or around it, so that bodies meet.
  const float q = random.one_in(2) ? line.q : -line.q, r = line.r;
  std::vector<std::array<float, 3>> points = {at(q, q, 0), at(r, r, 0), on_grid()};
  while (points.size() < corners(a) + corners(b))
    points.push_back(random.one_in(3)   ? on_grid()
                     : random.one_in(2) ? at(random.one_in(2) ? r : q, random.one_in(2) ? r : -r, lift())
                                        : at(q, q, 8)); // a plane through the line, across the grid's
  if (random.one_in(2))                                 // any point in any place; else one body has the line
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[random.bits() % i]);
  else if (corners(a) < corners(b))
    std::rotate(points.begin(), points.begin() + 2, points.end());
  pair_of_rows p;
  for (std::size_t i = 0; i < corners(a) + corners(b); ++i)
    for (const float c : points[i])
      (i < corners(a) ? p.a : p.b).push_back(c);
  finish(a, p.a, random, line.step);
  finish(b, p.b, random, line.step);
  return p;
}

pair_of_rows near_coplanar(shape a, shape b, random_numbers &random) {
  const bool swapped = corners(a) < corners(b);
  const shape base = swapped ? b : a, other = swapped ? a : b;
  std::array<vec, 3> at{}; // in steps of 2^-24
  for (vec &p : at)
    for (long &c : p)
      c = 16L * random.integer(0, (1 << 20) - 1);
  pair_of_rows p;
  row &x = swapped ? p.b : p.a, &y = swapped ? p.a : p.b;
  for (std::size_t i = 0; i < corners(base); ++i)
    append(x, at[i]);
  for (std::size_t i = 0; i < corners(other); ++i) {
    const long s = random.integer(0, 16),
               t = corners(base) == 2 ? 0 : random.integer(0, random.one_in(2) ? 16 : 16 - static_cast<int>(s));
    vec d{};
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = at[0][k] + (s * (at[1][k] - at[0][k]) + t * (at[2][k] - at[0][k])) / 16;
    if (random.one_in(2))
      d[static_cast<std::size_t>(random.integer(0, 2))] += random.one_in(2) ? 1 : -1;
    if (i > 0 && random.one_in(3)) // elsewhere
      for (long &c : d)
        c = 16L * random.integer(0, (1 << 20) - 1);
    append(y, d);
  }
  for (row *r : {&p.a, &p.b})
    for (float &c : *r)
      c *= 0x1p-24F;
  finish(base, x, random, 0x1p-24F);
  finish(other, y, random, 0x1p-24F);
  return p;
}

} // namespace meetc::extremes_test
