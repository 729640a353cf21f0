// Families of whole steps: at subnormal height, on planes through the origin, as long as doubles are exact, and along long
// segments.
#include "tests/extremes/families/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meetc::extremes_test {
namespace {

using generated_test::stepped;
using steps = std::array<long, 3>;

void append(row &r, const steps &p, int exponent) {
  for (const long c : p)
    r.push_back(std::ldexp(static_cast<float>(c), exponent));
}

// The axes in another order, and now and then reflected: points of both bodies, whose radii stay.
void turn_axes(shape a, shape b, pair_of_rows &p, random_numbers &random) {
  std::array<std::size_t, 3> axis = {0, 1, 2};
  for (std::size_t i = 2; i > 0; --i)
    std::swap(axis[i], axis[random.bits() % (i + 1)]);
  const float sign[3] = {random.one_in(2) ? 1.0F : -1.0F, random.one_in(2) ? 1.0F : -1.0F,
                         random.one_in(2) ? 1.0F : -1.0F};
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)})
    for (std::size_t i = 0; i < 3 * corners(kind); i += 3) {
      const float at[3] = {(*r)[i], (*r)[i + 1], (*r)[i + 2]};
      for (std::size_t k = 0; k < 3; ++k)
        (*r)[i + k] = sign[k] * at[axis[k]];
    }
}

// A radius of a few steps, or one at which the bodies just touch.
void add_radii(shape a, shape b, pair_of_rows &p, float step, random_numbers &random) {
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)})
    if (padded(kind))
      r->push_back(step * static_cast<float>(random.one_in(2) ? 0 : random.integer(0, 6)));
  if (padded(a) && random.one_in(2))
    graze(a, b, p, random);
}

} // namespace

pair_of_rows flat_subnormal(shape a, shape b, random_numbers &random) {
  const int height = random.integer(0, 3) == 0 ? 0 : random.integer(1, 0x7fffff) >> random.integer(0, 22),
            reach = random.integer(1, 6);
  // Ordinary numbers beside it, subnormal ones, or the least normal ones.
  static constexpr int exponents[] = {-2, -149, -128, -126, 20};
  const int exponent = exponents[random.integer(0, 4)];
  pair_of_rows p;
  const auto draw = [&](shape kind, row &r) {
    for (std::size_t i = 0; i < corners(kind); ++i) {
      append(r, {random.integer(-reach, reach), random.integer(-reach, reach), 0}, exponent);
      r.back() = 0x1p-149F * static_cast<float>(height + (random.one_in(6) ? random.integer(-1, 1) : 0));
    }
  };
  draw(a, p.a), draw(b, p.b);
  turn_axes(a, b, p, random);
  add_radii(a, b, p, random.one_in(2) ? 0x1p-149F : std::ldexp(1.0F, exponent), random);
  return p;
}

pair_of_rows plane_binades(shape a, shape b, random_numbers &random) {
  static constexpr float factors[] = {0, 1, -1, 2, 3, -3, 0.5F, 5, 0.75F, 7};
  const float of_x = factors[random.integer(0, 9)], of_y = factors[random.integer(0, 9)];
  const int highest = random.one_in(2) ? 0 : random.integer(-122, 110), spread = random.one_in(4) ? 6 : 26;
  const auto number = [&] {
    const int bits = random.integer(1, 7), odd = random.integer(0, (1 << bits) - 1);
    return std::ldexp(static_cast<float>(random.one_in(2) ? odd : -odd), highest - random.integer(0, spread));
  };
  pair_of_rows p;
  const auto draw = [&](shape kind, row &r) {
    for (std::size_t i = 0; i < corners(kind); ++i) {
      const float x = number(), y = number();
      // Exact in double, mostly in float32 as well; else the point is half a step off the plane, at most.
      const auto z = static_cast<float>(static_cast<double>(of_x) * x + static_cast<double>(of_y) * y);
      r.insert(r.end(), {x, y, random.one_in(12) ? stepped(z, random.one_in(2) ? 1 : -1) : z});
    }
  };
  draw(a, p.a), draw(b, p.b);
  // Corners of the second body on corners and edges of the first, so that bodies of so different sizes meet.
  for (std::size_t i = 0; i < corners(b); ++i)
    if (random.one_in(3)) {
      const std::size_t from = random.bits() % corners(a);
      std::copy_n(p.a.begin() + static_cast<std::ptrdiff_t>(3 * from), 3,
                  p.b.begin() + static_cast<std::ptrdiff_t>(3 * i));
    } else if (random.one_in(3)) {
      for (std::size_t k = 0; k < 3; ++k)
        p.b[3 * i + k] = p.a[3 * (random.bits() % corners(a)) + k] / 2 + p.b[3 * i + k] / 2;
    }
  turn_axes(a, b, p, random);
  add_radii(a, b, p, std::ldexp(1.0F, std::max(highest - random.integer(0, spread), -149)), random);
  return p;
}

pair_of_rows at_exact_steps(shape a, shape b, random_numbers &random) {
  // The longest difference is within three steps of the longest for which doubles are exact.
  const std::span<const double> limits = exact_limits(a, b);
  const auto limit = static_cast<long>(limits[random.bits() % limits.size()]);
  const long longest = std::min(limit, 1L << 24) + random.integer(-3, 3);
  // A parallelogram: o, o + u, o + v and o + u + v, which is `longest` from o along an axis. All else lies in its plane.
  steps u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = random.one_in(3) ? longest / 2 + random.integer(-9, 9)
                            : static_cast<long>(random.bits() % static_cast<std::uint64_t>(longest + 1));
    v[k] = longest - u[k];
  }
  const std::size_t other = random.bits() % 3; // along which the plane is not a diagonal one
  v[other] = random.one_in(2) ? -u[other] + random.integer(-9, 9) : u[other] - longest;
  const std::size_t turned = (other + 1) % 3;
  if (random.one_in(2))
    u[turned] = -u[turned], v[turned] = -v[turned];
  std::vector<steps> points;
  for (const auto &[s, t] : {std::pair(0, 0), std::pair(1, 1), std::pair(1, 0), std::pair(0, 1)})
    points.push_back({s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]});
  while (points.size() < corners(a) + corners(b)) {
    const steps at = points[random.bits() % 4];
    points.push_back(random.one_in(2) ? at
                                      : steps{at[0] / 2 + points[1][0] / 2, at[1] / 2 + points[1][1] / 2,
                                              at[2] / 2 + points[1][2] / 2});
  }
  points.resize(corners(a) + corners(b));
  if (random.one_in(2))
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[random.bits() % i]);
  if (random.one_in(2)) { // off the plane, by a step or two
    steps &moved = points[random.bits() % points.size()];
    moved[random.bits() % 3] += random.one_in(2) ? random.integer(1, 2) : -random.integer(1, 2);
  }
  const int exponent = random.one_in(2) ? 0 : random.integer(-149, 100);
  pair_of_rows p;
  for (std::size_t i = 0; i < points.size(); ++i)
    append(i < corners(a) ? p.a : p.b, points[i], exponent);
  turn_axes(a, b, p, random);
  add_radii(a, b, p, std::ldexp(random.one_in(3) ? static_cast<float>(longest / 2) : 1.0F, exponent), random);
  return p;
}

pair_of_rows long_lattice(shape a, shape b, random_numbers &random) {
  const bool swapped = corners(a) < corners(b);
  const shape base = swapped ? b : a, other = swapped ? a : b;
  // `cells` steps of a short vector, from one lattice point to another, along 2^18 cells of an axis.
  steps step;
  for (long &c : step)
    c = random.integer(-7, 7);
  long widest = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
  if (widest == 0)
    step[0] = widest = 1;
  const long cells = (1L << 18) / widest;
  steps start;
  for (long &c : start)
    c = random.one_in(2) ? 0 : random.integer(-(1 << 20), 1 << 20);
  const auto along = [&](long i) {
    return steps{start[0] + i * step[0], start[1] + i * step[1], start[2] + i * step[2]};
  };
  const auto anywhere = [&] { return static_cast<long>(random.bits() % static_cast<std::uint64_t>(cells + 1)); };
  const auto beside = [&](steps p) {
    p[random.bits() % 3] += random.one_in(2) ? 1 : -1;
    return p;
  };
  const auto away = [&] {
    steps p = along(anywhere());
    for (long &c : p)
      c += random.integer(-(1 << random.integer(1, 18)), 1 << random.integer(1, 18));
    return p;
  };
  std::vector<steps> line = {along(0), along(cells), away()};
  if (random.one_in(4)) // the end is off the lattice line: nothing between lies on it
    line[1] = beside(line[1]);
  if (random.one_in(2))
    std::swap(line[0], line[1]);
  std::vector<steps> points = {along(anywhere())};
  if (random.one_in(2))
    points[0] = beside(points[0]);
  while (points.size() < corners(other))
    points.push_back(random.one_in(3) ? along(anywhere()) : random.one_in(2) ? beside(points[0]) : away());
  if (corners(other) == 2 && random.one_in(3)) // a segment across, around a point of the line
    for (std::size_t k = 0; k < 3; ++k)
      points[1][k] = 2 * line[random.bits() % 2][k] - points[0][k];
  const int exponent = random.one_in(2) ? -10 : random.integer(-149, 100);
  pair_of_rows p;
  row &x = swapped ? p.b : p.a, &y = swapped ? p.a : p.b;
  for (std::size_t i = 0; i < corners(base); ++i)
    append(x, line[i], exponent);
  for (std::size_t i = 0; i < corners(other); ++i)
    append(y, points[i], exponent);
  turn_axes(a, b, p, random);
  add_radii(a, b, p, std::ldexp(1.0F, exponent), random);
  return p;
}

} // namespace meetc::extremes_test
