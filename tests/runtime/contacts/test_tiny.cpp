// The enclosures of coordinates in arithmetic of few bits, where a bound that is too small soon gives a wrong number: the
// bounds of place.hpp, ball_line.hpp and root_place.hpp against integers, and bounds that are parts of theirs.
#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <meetc/contact/place.hpp>
#include <meetc/contact/root_place.hpp>
#include <random>

namespace {

// x rounded to so many bits, to the nearest and of two to the even one.
double rounded(double x, int bits) {
  if (x == 0)
    return x;
  const int scale = bits - 1 - std::ilogb(x);
  return std::scalbn(std::nearbyint(std::scalbn(x, scale)), -scale);
}

// Numbers of `bits` bits in the place of float64.
template <int bits> struct tiny {
  double v = 0;
  tiny() = default;
  explicit tiny(double x) : v(rounded(x, bits)) {}
  friend tiny operator+(tiny a, tiny b) { return tiny(a.v + b.v); }
  friend tiny operator+(tiny a, double b) { return tiny(a.v + b); }
  friend tiny operator-(tiny a, tiny b) { return tiny(a.v - b.v); }
  friend tiny operator*(tiny a, tiny b) { return tiny(a.v * b.v); }
  friend tiny operator*(tiny a, double b) { return tiny(a.v * b); }
  friend tiny operator-(tiny a) { return tiny(-a.v); }
  friend double leading(tiny a) { return a.v; }
  friend tiny square_root(tiny a) { return tiny(a.v > 0 ? std::sqrt(a.v) : 0); }
};

// Numbers of `bits` bits in the place of float32, of an arithmetic with `wide` bits whose roundings are taken for one `part` of
// what they are.
template <int bits, int wide, int part> struct narrow {
  double v = 0;
  narrow() = default;
  explicit narrow(double x) : v(rounded(x, bits)) {}
  friend bool operator<(narrow a, narrow b) { return a.v < b.v; }
  friend bool operator>(narrow a, narrow b) { return a.v > b.v; }
  friend bool operator==(narrow a, narrow b) { return a.v == b.v; }
  friend bool operator==(narrow a, int b) { return a.v == b; }
};

} // namespace

namespace meetc {
template <int bits, int wide, int part> struct place_arithmetic<narrow<bits, wide, part>> {
  using number = tiny<wide>;
  static constexpr double u = 1.0 / (1 << wide) / part;
  static number difference(double x, double y) { return number(x - y); }
  static number quotient(number x, number y) { return number(x.v / y.v); }
  static narrow<bits, wide, part> end(number x, double error) { return narrow<bits, wide, part>(x.v + error); }
};
} // namespace meetc

namespace {

using integers = std::array<int, 3>;

std::int64_t dot(const integers &a, const integers &b) {
  return std::int64_t{a[0]} * b[0] + std::int64_t{a[1]} * b[1] + std::int64_t{a[2]} * b[2];
}
integers minus(const integers &a, const integers &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
integers cross(const integers &a, const integers &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Two to four bits and an exponent, of either sign.
int some_number(std::mt19937 &random) {
  const int x = static_cast<int>(random() % 16) << random() % 5;
  return random() % 2 == 0 ? x : -x;
}
integers some_point(std::mt19937 &random) {
  return {some_number(random), some_number(random), some_number(random)};
}

struct row {
  float x[3];
  explicit row(const integers &p) : x{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])} {}
};

__extension__ using int128 = __int128;

// n / d, d > 0, rounded to bits: a double is so much finer that it decides all but ties, which integers decide.
double nearest(std::int64_t n, std::int64_t d, int bits) {
  const double q = static_cast<double>(n) / static_cast<double>(d);
  if (q == 0)
    return 0;
  const double unit = std::scalbn(1, std::ilogb(q) - bits + 1), below = std::floor(q / unit) * unit;
  const auto twice = static_cast<std::int64_t>(std::scalbn(2 * below + unit, 20)); // exact
  const auto middle = static_cast<int128>(twice) * d, at = static_cast<int128>(n) << 21;
  if (middle == at)
    return rounded(below + unit / 2, bits);
  return at < middle ? below : below + unit;
}

struct tally {
  long found = 0, wrong = 0;
};

// The coordinates of points in which an edge crosses a face.
template <int bits, int wide, int part> tally faces(int cases) {
  using real = narrow<bits, wide, part>;
  std::mt19937 random(7);
  tally out;
  for (int i = 0; i < cases;) {
    integers p = some_point(random), q = some_point(random);
    std::array<integers, 3> t = {some_point(random), some_point(random), some_point(random)};
    if (random() % 2 == 0) // a short edge in the middle of the face, near 0, where its heights cancel
      for (std::size_t k = 0; k < 3; ++k) {
        const auto few = [&random] { return static_cast<int>(random() % 15) - 7; };
        p[k] = few(), q[k] = few(), t[2][k] = few() - t[0][k] - t[1][k];
      }
    const integers normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    const std::int64_t at_p = dot(normal, minus(p, t[0])), at_q = dot(normal, minus(q, t[0]));
    if (at_p == 0 || at_q == 0 || (at_p > 0) == (at_q > 0))
      continue;
    int sides = 0; // of the edge to those of the face
    for (std::size_t k = 0; k < 3; ++k)
      sides += dot(cross(minus(q, p), minus(t[k], p)), minus(t[(k + 1) % 3], p)) > 0 ? 1 : -1;
    if (sides != 3 && sides != -3)
      continue;
    ++i;
    const row rp(p), rq(q);
    const std::array<row, 3> rt = {row(t[0]), row(t[1]), row(t[2])};
    const float face[9] = {rt[0].x[0], rt[0].x[1], rt[0].x[2], rt[1].x[0], rt[1].x[1],
                           rt[1].x[2], rt[2].x[0], rt[2].x[1], rt[2].x[2]};
    const float edge[6] = {rp.x[0], rp.x[1], rp.x[2], rq.x[0], rq.x[1], rq.x[2]};
    const meetc::label_place<real> place(
        meetc::label_points({edge, 2}, {face, 3}, meetc::label_of(meetc::first_edge, meetc::open_face)));
    const std::int64_t below = std::abs(at_p) + std::abs(at_q);
    for (std::size_t k = 0; k < 3; ++k)
      if (real x; place.find(static_cast<int>(k), x)) {
        ++out.found;
        out.wrong += x.v != nearest(p[k] * std::abs(at_q) + q[k] * std::abs(at_p), below, bits);
      }
  }
  return out;
}

// The coordinates of points in which two edges in one plane cross.
template <int bits, int wide, int part> tally edges(int cases) {
  using real = narrow<bits, wide, part>;
  std::mt19937 random(8);
  tally out;
  for (int i = 0; i < cases;) {
    const int slope_x = static_cast<int>(random() % 3) - 1, slope_y = static_cast<int>(random() % 3) - 1;
    std::array<integers, 4> points;
    for (integers &x : points)
      x = some_point(random), x[2] = slope_x * x[0] + slope_y * x[1];
    const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
      return std::int64_t{cross(minus(points[b], points[a]), minus(points[c], points[a]))[2]};
    };
    const std::int64_t at_p = turn(2, 3, 0), at_q = turn(2, 3, 1), at_u = turn(0, 1, 2), at_v = turn(0, 1, 3);
    if (at_p == 0 || at_q == 0 || at_u == 0 || at_v == 0 || (at_p > 0) == (at_q > 0) || (at_u > 0) == (at_v > 0))
      continue;
    ++i;
    float rows[2][6];
    for (std::size_t j = 0; j < 12; ++j)
      rows[j / 6][j % 6] = static_cast<float>(points[j / 3][j % 3]);
    const meetc::label_place<real> place(
        meetc::label_points({rows[0], 2}, {rows[1], 2}, meetc::label_of(meetc::first_edge, meetc::first_edge)));
    const std::int64_t below = std::abs(at_p) + std::abs(at_q);
    for (std::size_t k = 0; k < 3; ++k)
      if (real x; place.find(static_cast<int>(k), x)) {
        ++out.found;
        const std::int64_t above = points[0][k] * std::abs(at_q) + points[1][k] * std::abs(at_p);
        out.wrong += x.v != nearest(above, below, bits);
      }
  }
  return out;
}

// The signs of a segment and a ball, and the coordinates of their roots. Doubles are so much finer that they are the truth of
// these, up to one part of 2^40.
template <int bits, int wide, int part> tally roots(int cases) {
  using real = narrow<bits, wide, part>;
  std::mt19937 random(9);
  tally out;
  for (int i = 0; i < cases;) {
    const integers c = some_point(random), p = some_point(random), q = some_point(random);
    const std::int64_t r = std::abs(some_number(random));
    const integers d = minus(q, p), w = minus(c, p);
    const std::int64_t b = dot(w, d), square = dot(d, d), discriminant = b * b - square * (dot(w, w) - r * r);
    if (square == 0)
      continue;
    ++i;
    const row rc(c), rp(p), rq(q);
    const float ball[4] = {rc.x[0], rc.x[1], rc.x[2], static_cast<float>(r)};
    const float segment[6] = {rp.x[0], rp.x[1], rp.x[2], rq.x[0], rq.x[1], rq.x[2]};
    const meetc::ball_line<real> line(ball, segment);
    const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
    for (const auto &[told, is] :
         {std::pair(line.sign_of_b(), sign(b)), std::pair(line.sign_of_d(), sign(discriminant))})
      if (told != 2)
        ++out.found, out.wrong += told != is;
    if (discriminant < 0)
      continue;
    for (const int which : {meetc::first_root, meetc::second_root}) {
      const double s = std::sqrt(static_cast<double>(discriminant));
      const double t = (static_cast<double>(b) + (which == meetc::first_root ? -s : s)) / static_cast<double>(square);
      if (t < 0 || t > 1)
        continue;
      const auto root = line.root(discriminant == 0 ? meetc::double_root : which);
      for (std::size_t k = 0; k < 3; ++k) {
        const float least = std::fmin(segment[k], segment[3 + k]), most = std::fmax(segment[k], segment[3 + k]);
        real from(least), to(most);
        meetc::cut_to_root(root, segment[k], segment[3 + k], from, to);
        const double x = p[k] + t * d[k], off = std::scalbn(std::abs(p[k]) + std::abs(d[k]), -40);
        ++out.found;
        out.wrong += to.v < rounded(x - off, bits) || from.v > rounded(x + off, bits);
      }
    }
  }
  return out;
}

} // namespace

// The bounds, and a part of them. An enclosure adds several bounds, each with room for all its roundings at their worst, so
// that only a small part of it soon gives a wrong number.
#define HOLDS(what, bits, wide, cases)                                                                                 \
  do {                                                                                                                 \
    const tally whole = what<bits, wide, 1>(cases), part = what<bits, wide, 64>(cases);                                \
    CAPTURE(bits, wide, whole.found, part.found, part.wrong);                                                          \
    CHECK(whole.found > 0);                                                                                            \
    CHECK(whole.wrong == 0);                                                                                           \
    CHECK(part.found > whole.found);                                                                                   \
    CHECK(part.wrong > (cases) / 20'000);                                                                              \
  } while (false)

TEST_CASE("the bounds of coordinates hold in arithmetic of few bits, and parts of them do not") {
  HOLDS(faces, 2, 6, 100'000);
  HOLDS(faces, 4, 6, 100'000);
  HOLDS(faces, 3, 8, 100'000);
  HOLDS(faces, 4, 11, 100'000);
  HOLDS(edges, 2, 6, 100'000);
  HOLDS(edges, 4, 6, 100'000);
  HOLDS(edges, 3, 8, 100'000);
  HOLDS(edges, 4, 11, 100'000);
}

TEST_CASE("the bounds of roots hold in arithmetic of few bits, and parts of them do not") {
  HOLDS(roots, 2, 6, 100'000);
  HOLDS(roots, 4, 6, 100'000);
  HOLDS(roots, 3, 8, 100'000);
  HOLDS(roots, 4, 11, 100'000);
}
