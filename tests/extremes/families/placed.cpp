// Bodies that touch in a point placed exactly on a corner, inside an edge or inside a face of each, and
// otherwise lie on either side of a plane: a corner on an edge, an edge across an edge, a sphere against a
// face, and so on.
//
// All numbers are integers in a frame about that point: it is inside the edge from m1 d to -m0 d, and inside the
// triangle m2 p, m2 q, -(m0 p + m1 q), whatever d, p, q and the positive m are.
#include "frames.hpp"
#include "tests/extremes/families/families.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace meetc::extremes_test {
namespace {

using point = integer_point;
constexpr int reach = 8, multiples = 5;

// A hull that has 0 in it; what has 0 inside lies in the plane across x, the rest on that side of it (1, -1),
// or anywhere (0).
std::vector<point> hull_through(const frame &f, std::size_t size, int side, random_numbers &random) {
  const auto across = [&] { return random.integer(-reach, reach); };
  const auto multiple = [&] { return random.integer(1, multiples); };
  std::vector<point> out = {point{}};
  const int kind = random.integer(0, static_cast<int>(size) - 1); // corner, edge, face
  if (kind == 1) {
    const int y = across(), z = across(), m = multiple(), n = multiple();
    out = {in(f, 0, m * y, m * z), in(f, 0, -n * y, -n * z)};
  } else if (kind == 2) {
    const int py = across(), pz = across(), qy = across(), qz = across();
    const int k = multiple(), m = multiple(), n = multiple();
    out = {in(f, 0, k * py, k * pz), in(f, 0, k * qy, k * qz), in(f, 0, -m * py - n * qy, -m * pz - n * qz)};
  }
  while (out.size() < size) {
    const int x = side == 0 ? across() : side * random.integer(0, reach), y = across(), z = across();
    out.push_back(in(f, x, y, z));
  }
  std::rotate(out.begin(), out.begin() + random.integer(0, static_cast<int>(size) - 1), out.end());
  return out;
}

float exactly(long c) {
  const auto f = static_cast<float>(c);
  if (static_cast<long>(f) != c)
    throw std::logic_error("a placed number is no float32");
  return f;
}

} // namespace

pair_of_rows placed_exactly(shape a, shape b, random_numbers &random) {
  const frame f = any_frame(random.one_in(2) ? 2 : 8, random);
  point shift{};
  if (random.one_in(2))
    for (long &c : shift)
      c = random.one_in(3) ? 0 : random.integer(-(1 << 22), 1 << 22) >> random.integer(0, 18);
  const int exponent = random.one_in(2) ? 0 : random.integer(-149, 100);
  pair_of_rows p;
  for (const auto &[kind, r, own_side] : {std::tuple(a, &p.a, 1), std::tuple(b, &p.b, -1)}) {
    const int side = random.one_in(4) ? 0 : own_side;
    std::vector<point> points;
    long radius = 0;
    if (padded(kind)) { // from outside, or one sphere within the other
      const int k = random.integer(0, 64) * (side == 0 ? -own_side : own_side);
      points = {in(f, k, 0, 0)};
      radius = std::abs(k) * f.length;
    } else {
      points = hull_through(f, corners(kind), side, random);
    }
    for (const point &c : points)
      for (std::size_t k = 0; k < 3; ++k)
        r->push_back(exactly(c[k] + shift[k]));
    if (padded(kind))
      r->push_back(exactly(radius));
  }
  // Multiples of 2^-149 below 2^124: nothing is rounded.
  return {generated_test::scaled(p.a, exponent), generated_test::scaled(p.b, exponent)};
}

pair_of_rows placed(shape a, shape b, random_numbers &random) {
  pair_of_rows p = placed_exactly(a, b, random);
  if (random.one_in(2)) { // one number by one ulp
    row &r = random.one_in(2) ? p.a : p.b;
    float &c = r[random.bits() % r.size()];
    const bool radius = &c == &r.back() && padded(&r == &p.a ? a : b);
    c = generated_test::stepped(c, random.one_in(2) ? 1 : -1);
    c = radius ? std::abs(c) : c;
  }
  return p;
}

} // namespace meetc::extremes_test
