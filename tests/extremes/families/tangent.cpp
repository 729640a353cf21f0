// Spheres that touch a corner, an edge, a face or another sphere in exactly one point, or are one ulp away from that.
#include "frames.hpp"
#include "tests/extremes/families/families.hpp"

#include <cmath>

namespace meetc::extremes_test {
namespace {

using vec = integer_point;
constexpr float unit = 0x1p-6F;

void append(row &r, const vec &p, float size) {
  for (const long c : p)
    r.push_back(static_cast<float>(c) * size);
}

// Corners of a hull that has the touching point in it and, but for that, lies beyond the plane through it
// across x: the point is a corner, inside an edge, or inside the face. Or all but that corner is inside of
// the sphere about -k x: its surface is touched from within.
std::vector<vec> hull_at(const frame &f, int k, int reach, std::size_t size, random_numbers &random) {
  const auto across = [&] { return random.integer(-reach, reach); };
  std::vector<vec> out = {vec{}};
  const bool inside = random.one_in(4);
  if (size > 1 && !inside && !random.one_in(3)) {
    const int y = across(), z = across();
    if (size == 3 && random.one_in(2)) {
      const int u = across(), v = across();
      return {in(f, 0, y, z), in(f, 0, u, v), in(f, 0, -y - u, -z - v)}; // about their centre
    }
    const int s = random.integer(1, reach), t = random.integer(1, reach);
    out = {in(f, 0, s * y, s * z), in(f, 0, -t * y, -t * z)};
  }
  while (out.size() < size)
    out.push_back(inside
                      ? in(f, random.integer(-k, -k / 2), random.integer(-k / 2, k / 2), random.integer(-k / 2, k / 2))
                      : in(f, random.integer(0, 8), across(), across()));
  return out;
}

} // namespace

pair_of_rows tangent(shape a, shape b, random_numbers &random) {
  // Small numbers, or numbers that fill their 24 bits.
  static constexpr struct { int quaternion, multiple; } most[] = {{2, 64}, {2, 1 << 18}, {8, 64}, {256, 32}, {1024, 2}};
  const auto [quaternion, multiple] = most[random.integer(0, 4)];
  const frame f = any_frame(quaternion, random);
  const int k = random.integer(1, multiple);
  // The sphere's centre and the others' corners, from the touching point; and a radius of the second.
  const vec centre = in(f, -k, 0, 0);
  const int other = padded(b) ? random.integer(0, multiple) : 0;
  std::vector<vec> touching = {in(f, random.one_in(2) ? other : -other, 0, 0)}; // from outside, from inside
  if (!padded(b)) {
    touching = hull_at(f, k, std::min(multiple, 16), corners(b), random);
    std::rotate(touching.begin(), touching.begin() + random.integer(0, points_of(b) - 1), touching.end());
  }
  // About that point all may have any sizes, exactly: corners stay on their rays.
  const bool at_origin = random.one_in(2), several = random.one_in(2);
  const auto any_size = [&] {
    return std::ldexp(unit, random.one_in(2) ? random.integer(-5, 5) : random.integer(-24, 24));
  };
  const float size = at_origin && random.one_in(2) ? any_size() : unit;
  pair_of_rows p;
  append(p.a, centre, unit);
  for (const vec &c : touching)
    append(p.b, c, at_origin && several && !padded(b) ? any_size() : size);
  p.a.push_back(static_cast<float>(k * f.length) * unit);
  if (padded(b))
    p.b.push_back(static_cast<float>(other * f.length) * size);
  if (!at_origin) { // up to 1e5: exact where the sizes are the usual ones, 23 bits
    float t[3];
    for (std::size_t i = 0; i < 3; ++i)
      t[i] = -p.a[i] + static_cast<float>(random.integer(0, 1) * random.integer(-100000, 100000));
    p = {moved(a, p.a, t), moved(b, p.b, t)};
  }
  if (!random.one_in(3)) { // one ulp either way, of a radius or of any number, or a small step aside
    row &r = random.one_in(2) ? p.a : p.b;
    const bool radius = (&r == &p.a || padded(b)) && random.one_in(2);
    float &c = radius ? r.back() : r[static_cast<std::size_t>(random.bits() % (3 * corners(&r == &p.a ? a : b)))];
    const bool aside = random.one_in(3) || (c == 0 && !random.one_in(4));
    c = aside ? c + std::ldexp(1.0F, std::ilogb(p.a.back()) - random.integer(20, 32))
              : generated_test::stepped(c, random.one_in(2) ? 1 : -1);
    if (radius)
      c = std::abs(c);
  }
  return p;
}

} // namespace meetc::extremes_test
