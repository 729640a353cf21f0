#include "tests/generated/judge/operands.hpp"

#include "tests/generated/judge/judge.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace meetc::generated_test {
namespace {

constexpr float most = std::numeric_limits<float>::max();

std::size_t at(random_numbers &r, std::size_t size) {
  return static_cast<std::size_t>(r.bits() % size);
}

row with_radius(shape kind, row r, float radius) {
  if (padded(kind))
    r.push_back(radius);
  return r;
}

template <class Next> row draw(shape kind, Next &&next) {
  row r;
  for (int i = 0; i < 3 * points_of(kind); ++i)
    r.push_back(next());
  return with_radius(kind, r, std::abs(next()));
}

void copy_corner(const row &from, std::size_t i, row &to, std::size_t j) {
  for (std::size_t k = 0; k < 3; ++k)
    to[3 * j + k] = from[3 * i + k];
}

// Small integers. Corners of b are often corners of a, or the midpoint of one of its edges.
pair_of_rows lattice(shape a, shape b, random_numbers &random) {
  static constexpr int sizes[] = {1, 2, 5};
  const int size = sizes[random.integer(0, 2)];
  const auto next = [&] { return static_cast<float>(random.integer(0, size)); };
  pair_of_rows p{draw(a, next), draw(b, next)};
  const auto na = static_cast<std::size_t>(points_of(a));
  for (std::size_t j = 0; j < static_cast<std::size_t>(points_of(b)); ++j)
    if (random.one_in(4))
      copy_corner(p.a, at(random, na), p.b, j);
    else if (na > 1 && random.one_in(6))
      for (std::size_t k = 0; k < 3; ++k)
        p.b[3 * j + k] = (p.a[k] + p.a[3 + k]) / 2;
  return p;
}

// Random mantissas. b is about as large as a, or much smaller and near one of its corners.
pair_of_rows ordinary(shape a, shape b, random_numbers &random) {
  pair_of_rows p{draw(a, [&] { return random.unit(); }), {}};
  const float size = random.one_in(2) ? 1.0F : std::ldexp(1.0F, -random.integer(1, 12));
  const std::size_t near = 3 * at(random, static_cast<std::size_t>(points_of(a)));
  p.b = draw(b, [&] { return random.unit() * size; });
  if (size < 1)
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(points_of(b)); ++i)
      p.b[i] += p.a[near + i % 3];
  return p;
}

// The same numbers in both: shared corners and edges, duplicates.
pair_of_rows shared(shape a, shape b, random_numbers &random) {
  pair_of_rows p = ordinary(a, b, random);
  const auto na = static_cast<std::size_t>(points_of(a));
  const std::size_t first = at(random, na);
  for (std::size_t j = 0; j < static_cast<std::size_t>(points_of(b)); ++j)
    if (j == 0 || random.one_in(2))
      copy_corner(p.a, (first + j) % na, p.b, j);
  if (padded(a) && padded(b) && random.one_in(2))
    p.b[3] = stepped(p.a[3], random.integer(-1, 1));
  return p;
}

// Corners of b computed on corners, edges and the face of a in rounded arithmetic, perhaps a step or two off.
pair_of_rows computed_on(shape a, shape b, random_numbers &random) {
  pair_of_rows p = ordinary(a, b, random);
  const auto na = static_cast<std::size_t>(points_of(a));
  for (std::size_t j = 0; j < static_cast<std::size_t>(points_of(b)); ++j) {
    if (j > 0 && random.one_in(3))
      continue;
    const float s = static_cast<float>(random.integer(0, 16)) / 16, t = random.one_in(2) ? 0 : (1 - s) / 3;
    const std::size_t o = at(random, na), u = (o + 1) % na, v = (o + 2) % na;
    for (std::size_t k = 0; k < 3; ++k) {
      const float base = p.a[3 * o + k];
      p.b[3 * j + k] = stepped(base + s * (p.a[3 * u + k] - base) + t * (p.a[3 * v + k] - base),
                               random.one_in(2) ? 0 : random.integer(-2, 2));
    }
  }
  return p;
}

// Integer points of an oblique plane or line, exactly: i u + j v with u, v of an orthogonal frame, so that spheres can
// touch exactly as well (rational directions (2,-2,1)/3 and (2,3,6)/7).
struct frame {
  int length;
  std::array<std::array<int, 3>, 3> axes;
};
constexpr frame frames[] = {{1, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                            {3, {{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}},
                            {7, {{{2, 3, 6}, {3, -6, 2}, {6, 2, -3}}}},
                            {9, {{{1, 4, 8}, {4, 7, -4}, {8, -4, 1}}}}};

pair_of_rows in_frame(shape a, shape b, random_numbers &random, int dimensions) {
  const frame &f = frames[random.integer(0, 3)];
  const std::size_t turn = at(random, 3);
  const auto put = [&](shape kind, bool lifted) {
    row r(3 * static_cast<std::size_t>(points_of(kind)));
    for (std::size_t i = 0; i < r.size(); i += 3)
      for (std::size_t d = 0; d < 3; ++d) {
        const int steps = static_cast<int>(d) < dimensions || lifted ? random.integer(0, 5) : 0;
        for (std::size_t k = 0; k < 3; ++k)
          r[i + k] += static_cast<float>(steps * f.axes[(d + turn) % 3][k]);
      }
    const int radius = random.integer(0, 6);
    return with_radius(kind, r, static_cast<float>(radius * f.length));
  };
  // A sphere may lie off the plane; it then touches faces, edges and corners from outside.
  pair_of_rows p{put(a, padded(a)), put(b, padded(b) && random.one_in(2))};
  const float unit = std::ldexp(1.0F, -random.integer(0, 6)); // k/64
  for (row *r : {&p.a, &p.b})
    for (float &c : *r)
      c *= unit;
  // Half of the time one number changes in its last bit.
  if (random.one_in(2)) {
    row &r = random.one_in(2) ? p.a : p.b;
    float &c = r[padded(a) && random.one_in(2) ? r.size() - 1 : at(random, r.size())];
    const float next = stepped(c, random.one_in(2) ? 1 : -1);
    c = (&c == &p.a.back() && padded(a)) || (&c == &p.b.back() && padded(b)) ? std::abs(next) : next;
  }
  return p;
}
pair_of_rows coplanar(shape a, shape b, random_numbers &random) {
  return in_frame(a, b, random, 2);
}
pair_of_rows collinear(shape a, shape b, random_numbers &random) {
  return in_frame(a, b, random, 1);
}
pair_of_rows solid_frame(shape a, shape b, random_numbers &random) {
  return in_frame(a, b, random, 3);
}

// Needles, zero-area triangles, zero-length segments, points.
pair_of_rows flat(shape a, shape b, random_numbers &random) {
  pair_of_rows p = random.one_in(2) ? computed_on(a, b, random) : lattice(a, b, random);
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)}) {
    const auto corners = static_cast<std::size_t>(points_of(kind));
    if (corners < 2 || random.one_in(3))
      continue;
    const std::size_t j = at(random, corners), i = (j + 1) % corners;
    copy_corner(*r, i, *r, j);
    if (random.one_in(2)) // a needle
      (*r)[3 * j + at(random, 3)] = stepped((*r)[3 * j], random.integer(-1, 1));
    else if (corners == 3 && random.one_in(2)) // a point
      copy_corner(*r, i, *r, (j + 2) % 3);
  }
  return p;
}

// A radius that is the rounded distance, the rounded greatest distance, or a step away from it. The deciding difference
// is too small for float, and at degree 6 for double.
pair_of_rows grazing(shape a, shape b, random_numbers &random) {
  pair_of_rows p = random.one_in(2) ? ordinary(a, b, random) : computed_on(a, b, random);
  if (padded(a))
    graze(a, b, p, random);
  return p;
}

using maker = pair_of_rows (*)(shape, shape, random_numbers &);
constexpr maker near_makers[] = {lattice,   ordinary,    shared, computed_on, coplanar,
                                 collinear, solid_frame, flat,   grazing};
pair_of_rows any_near(shape a, shape b, random_numbers &random) {
  return near_makers[at(random, std::size(near_makers))](a, b, random);
}

// Far from the origin and rounded to float32, so that many points coincide.
pair_of_rows far(shape a, shape b, random_numbers &random) {
  static constexpr float offsets[] = {1e4F, 1e6F, 1e7F, 3e7F};
  pair_of_rows p = any_near(a, b, random);
  float t[3];
  for (float &c : t)
    c = random.one_in(4) ? 0 : offsets[random.integer(0, 3)] * (random.one_in(2) ? 1.0F : -1.0F);
  const int k = random.integer(0, 6);
  return {moved(a, scaled(p.a, k), t), moved(b, scaled(p.b, k), t)};
}

// The whole range of exponents, including subnormals and the largest numbers.
pair_of_rows any_scale(shape a, shape b, random_numbers &random) {
  const pair_of_rows p = any_near(a, b, random);
  const int k = random.one_in(4) ? (random.one_in(2) ? random.integer(-149, -120) : random.integer(100, 127))
                                 : random.integer(-149, 127);
  return {scaled(p.a, k), scaled(p.b, k)};
}

// Huge and tiny numbers in one pair, which span 250 bits and more.
pair_of_rows mixed(shape a, shape b, random_numbers &random) {
  static constexpr float special[] = {0.0F,    -0.0F,     0x1p-149F, -0x1p-149F, 0x1p-126F, 0x1.fffffcp-127F,
                                      most,    -most,     1.0F,      -1.0F,      0x1p127F,  0x1.000002p0F,
                                      0x1p64F, -0x1p-64F, 3.0F,      0x1.8p-140F};
  pair_of_rows p = any_near(a, b, random);
  const int up = random.integer(60, 127), down = random.integer(-149, -60);
  switch (random.integer(0, 2)) {
  case 0: { // one body huge, the other tiny, about one point
    const bool swap = random.one_in(2);
    p = {scaled(p.a, swap ? up : down), scaled(p.b, swap ? down : up)};
    break;
  }
  case 1: // corners of either size
    for (row *r : {&p.a, &p.b})
      for (std::size_t i = 0; i < r->size(); i += 3) {
        const int k = random.one_in(2) ? up : random.one_in(2) ? down : 0;
        const row part = scaled(row(r->begin() + static_cast<std::ptrdiff_t>(i),
                                    r->begin() + static_cast<std::ptrdiff_t>(std::min(i + 3, r->size()))),
                                k);
        std::copy(part.begin(), part.end(), r->begin() + static_cast<std::ptrdiff_t>(i));
      }
    break;
  default: // single numbers replaced
    for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)})
      for (std::size_t i = 0; i < r->size(); ++i)
        if (random.one_in(3)) {
          const float f = special[random.integer(0, 15)];
          (*r)[i] = padded(kind) && i == 3 ? std::abs(f) : f;
        }
  }
  return p;
}

// Any finite bit pattern; sometimes only a few different ones.
pair_of_rows patterns(shape a, shape b, random_numbers &random) {
  const float few[3] = {random.pattern(), random.pattern(), random.pattern()};
  const bool often = random.one_in(2);
  const auto next = [&] { return often ? few[random.integer(0, 2)] : random.pattern(); };
  return {draw(a, next), draw(b, next)};
}

template <maker Make> pair_of_rows in_order(shape a, shape b, random_numbers &random) {
  pair_of_rows p = Make(a, b, random);
  put_in_order(a, p.a), put_in_order(b, p.b);
  return p;
}

constexpr family all_families[] = {
    {"lattice", in_order<lattice>},         {"ordinary", in_order<ordinary>},
    {"shared", in_order<shared>},           {"computed_on", in_order<computed_on>},
    {"coplanar", in_order<coplanar>},       {"collinear", in_order<collinear>},
    {"solid_frame", in_order<solid_frame>}, {"flat", in_order<flat>},
    {"grazing", in_order<grazing>},         {"far", in_order<far>},
    {"any_scale", in_order<any_scale>},     {"mixed", in_order<mixed>},
    {"patterns", in_order<patterns>},
};

} // namespace

std::span<const family> families() {
  return all_families;
}

void put_in_order(shape kind, row &r) {
  if (kind == shape::box)
    for (std::size_t k = 0; k < 3; ++k)
      if (r[3 + k] < r[k])
        std::swap(r[k], r[3 + k]);
}

row scaled(const row &r, int k) {
  row out;
  for (const float f : r)
    out.push_back(std::clamp(std::ldexp(f, k), -most, most));
  return out;
}

row moved(shape kind, const row &r, const float t[3]) {
  row out = r;
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(points_of(kind)); ++i)
    out[i] = std::clamp(r[i] + t[i % 3], -most, most);
  return out;
}

void graze(shape a, shape b, pair_of_rows &p, random_numbers &random) {
  const auto rounded = [](double d) { return static_cast<float>(std::min(d, static_cast<double>(most))); };
  const oracle::hull x = hull_of(a, p.a), y = hull_of(b, p.b);
  const bool far = random.one_in(3);
  const double d = std::sqrt((far ? oracle::max_squared_distance(x[0], y) : oracle::squared_distance(x, y)).get_d());
  if (padded(b)) { // tangent from outside or inside
    p.b[3] = rounded(d * random.integer(0, 8) / 8);
    p.a[3] =
        std::abs(stepped(rounded(far ? d + static_cast<double>(p.b[3]) : std::abs(d - static_cast<double>(p.b[3]))),
                         random.integer(-1, 1)));
  } else {
    p.a[3] = std::abs(stepped(rounded(d), random.integer(-1, 1)));
  }
}

float stepped(float f, int steps) {
  for (int i = 0; i < std::abs(steps); ++i)
    f = std::nextafter(f, steps > 0 ? most : -most);
  return f;
}

} // namespace meetc::generated_test
