// Exact distances and touches against known values, symmetries, and an unrelated computation in floating
// point.
#include "gen/oracle/convex.hpp"
#include "tests/catch.hpp"
#include "tests/gen/oracle/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

using namespace meetc::oracle;
using meetc::oracle_test::random_numbers;

namespace {

hull random_hull(random_numbers &r, int limit) {
  hull h;
  for (int n = r.integer(1, 3); n > 0; --n)
    h.push_back(at(r.integer(-limit, limit), r.integer(-limit, limit), r.integer(-limit, limit)));
  return h;
}

// ---- the same distance in double, by cases: corners on faces, edges on edges, edges through faces ----

using vec = std::array<double, 3>;
vec operator-(const vec &a, const vec &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
vec along(const vec &a, const vec &d, double t) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}
double dot(const vec &a, const vec &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
vec cross(const vec &a, const vec &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double square(const vec &a) {
  return dot(a, a);
}
constexpr double nil = 1e-9; // far below any non-zero value that small integers give

double point_segment(const vec &p, const vec &a, const vec &b) {
  const double l = square(b - a);
  const double t = l < nil ? 0 : std::clamp(dot(p - a, b - a) / l, 0.0, 1.0);
  return square(p - along(a, b - a, t));
}

bool over_triangle(const vec &p, const vec &a, const vec &b, const vec &c, const vec &n) {
  return dot(cross(b - a, p - a), n) > -nil && dot(cross(c - b, p - b), n) > -nil && dot(cross(a - c, p - c), n) > -nil;
}

double segment_segment(const vec &a, const vec &b, const vec &c, const vec &d) {
  double best =
      std::min({point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b), point_segment(d, a, b)});
  const vec u = b - a, v = d - c, w = c - a;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  if (det > nil) {
    const double s = (dot(u, w) * vv - dot(v, w) * uv) / det, t = (dot(u, w) * uv - dot(v, w) * uu) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
      best = std::min(best, square(along(a, u, s) - along(c, v, t)));
  }
  return best;
}

double by_cases(std::vector<vec> a, std::vector<vec> b) {
  // A segment or point is a triangle with a corner repeated.
  while (a.size() < 3)
    a.push_back(a.back());
  while (b.size() < 3)
    b.push_back(b.back());
  double best = 1e300;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      best = std::min(best, segment_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  for (int side = 0; side < 2; ++side, std::swap(a, b)) {
    const vec n = cross(b[1] - b[0], b[2] - b[0]);
    if (square(n) < nil)
      continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const vec p = a[i], q = a[(i + 1) % 3];
      const double h = dot(p - b[0], n), k = dot(q - b[0], n);
      if (over_triangle(p, b[0], b[1], b[2], n))
        best = std::min(best, h * h / square(n));
      if (h * k < -nil && over_triangle(along(p, q - p, h / (h - k)), b[0], b[1], b[2], n))
        best = 0;
    }
  }
  return best;
}

std::vector<vec> to_double(const hull &h) {
  std::vector<vec> r;
  for (const point &p : h)
    r.push_back({p[0].get_d(), p[1].get_d(), p[2].get_d()});
  return r;
}

} // namespace

TEST_CASE("convex: known distances") {
  const hull origin = {at(0, 0, 0)};
  const hull square_corner = {at(0, 0), at(4, 0), at(0, 4)};
  CHECK(squared_distance(origin, {at(1, 2, 2)}) == 9);
  CHECK(squared_distance(origin, {at(1, -5, 0), at(1, 5, 0)}) == 1);
  CHECK(squared_distance(origin, {at(1, 2, 0), at(1, 5, 0)}) == 5);
  CHECK(squared_distance(origin, {at(3, 0, 0), at(0, 3, 0), at(0, 0, 3)}) == 3);
  CHECK(squared_distance({at(1, 1, 7)}, square_corner) == 49);                            // over the face
  CHECK(squared_distance({at(3, 3, 0)}, square_corner) == 2);                             // beside the long edge
  CHECK(squared_distance({at(-3, -4, 0)}, square_corner) == 25);                          // at a corner
  CHECK(squared_distance({at(1, 1, -1), at(1, 1, 1)}, square_corner) == 0);               // through the face
  CHECK(squared_distance({at(1, 1, 1), at(2, 1, 1)}, square_corner) == 1);                // parallel above it
  CHECK(squared_distance({at(-1, 0, 1), at(1, 0, 1)}, {at(0, -1, 0), at(0, 1, 0)}) == 1); // skew
  const hull through = {at(1, 1, -1), at(1, 1, 1), at(9, 9, 1)};
  CHECK(squared_distance(through, square_corner) == 0);
  CHECK(squared_distance({at(rational(1, 3), 0, 0)}, {at(0, rational(1, 2), 0)}) == rational(13, 36));
  CHECK(squared_distance({at(0, 0), at(2, 0)}, {at(1, 3), at(5, 3)}) == 9); // in the plane
}

TEST_CASE("convex: degenerate hulls are the segment or point that they are") {
  const hull needle = {at(0, 0, 0), at(2, 2, 2), at(1, 1, 1)}, dot_hull = {at(1, 0, 0), at(1, 0, 0), at(1, 0, 0)};
  random_numbers r(1);
  for (int t = 0; t < 50; ++t) {
    const hull other = random_hull(r, 3);
    CHECK(squared_distance(needle, other) == squared_distance({at(0, 0, 0), at(2, 2, 2)}, other));
    CHECK(squared_distance(dot_hull, other) == squared_distance({at(1, 0, 0)}, other));
  }
  CHECK(squared_distance(needle, needle) == 0);
  CHECK(squared_distance(needle, dot_hull) == rational(2, 3));
}

TEST_CASE("convex: distances agree with cases in floating point, on a lattice full of degeneracies") {
  random_numbers r(2);
  int zeros = 0, apart = 0;
  for (int t = 0; t < 4000; ++t) {
    const hull a = random_hull(r, 1 + t % 3), b = random_hull(r, 1 + t % 3);
    const rational exact = squared_distance(a, b);
    const double other = by_cases(to_double(a), to_double(b));
    (exact == 0 ? zeros : apart) += 1;
    if (std::abs(exact.get_d() - other) > 1e-7 || (exact == 0) != (other < 1e-7))
      FAIL("exact " << exact << ", by cases " << other << " in case " << t);
  }
  CHECK(zeros > 300);
  CHECK(apart > 500);
}

TEST_CASE("convex: the distance is a lower bound that sampled points approach") {
  random_numbers r(3);
  constexpr int steps = 12;
  for (int t = 0; t < 40; ++t) {
    hull a = random_hull(r, 4), b = random_hull(r, 4);
    const double exact = std::sqrt(squared_distance(a, b).get_d());
    a.resize(3, a.back());
    b.resize(3, b.back());
    const std::vector<vec> x = to_double(a), y = to_double(b);
    double best = 1e300;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        for (int k = 0; k <= steps; ++k)
          for (int l = 0; k + l <= steps; ++l) {
            const vec p = along(along(x[0], x[1] - x[0], i / double{steps}), x[2] - x[0], j / double{steps});
            const vec q = along(along(y[0], y[1] - y[0], k / double{steps}), y[2] - y[0], l / double{steps});
            best = std::min(best, square(p - q));
          }
    CHECK(exact <= std::sqrt(best) + 1e-9);
    CHECK(std::sqrt(best) <= exact + 4.0); // half a grid cell of each side, of edges up to 8 sqrt(3)
  }
}

TEST_CASE("convex: symmetric, and blind to the order of the points") {
  random_numbers r(4);
  for (int t = 0; t < 60; ++t) {
    hull a = random_hull(r, 2), b = random_hull(r, 2);
    const rational d = squared_distance(a, b);
    CHECK(squared_distance(b, a) == d);
    const auto less = [](const point &p, const point &q) { return p < q; };
    std::sort(a.begin(), a.end(), less);
    std::sort(b.begin(), b.end(), less);
    do {
      do
        CHECK(squared_distance(a, b) == d);
      while (std::next_permutation(b.begin(), b.end(), less));
    } while (std::next_permutation(a.begin(), a.end(), less));
    // Motions that preserve the lattice: swap axes, mirror, shift.
    hull u = a, v = b;
    for (hull *h : {&u, &v})
      for (point &p : *h)
        p = at(rational(7 - p[2]), rational(p[0] + 5), rational(-p[1]));
    CHECK(squared_distance(u, v) == d);
  }
}

TEST_CASE("convex: the greatest distance is at a corner") {
  CHECK(max_squared_distance(at(0, 0, 0), {at(1, 2, 2)}) == 9);
  CHECK(max_squared_distance(at(0, 0, 0), {at(1, 2, 2), at(0, 0, 0), at(-4, 0, 0)}) == 16);
  CHECK(max_squared_distance(at(1, 1, 1), {at(1, 1, 1)}) == 0);
}

TEST_CASE("convex: solids touch up to the sum of their pads") {
  const hull a = {at(0, 0, 0)}, b = {at(2, -1, 2)}; // distance 3
  using enum touch_mode;
  CHECK(touches(a, 1, b, 2, solid));
  CHECK_FALSE(touches(a, 1, b, rational(1999999, 1000000), solid));
  CHECK(touches(a, 100, b, 0, solid)); // a point deep inside
  CHECK(touches(a, 0, a, 0, solid));
  CHECK_FALSE(touches(a, 0, b, 0, solid));
  // A capsule above a triangle, in every order.
  const hull segment = {at(0, 0, 5), at(1, 0, 6)}, triangle = {at(-9, -9, 0), at(9, -9, 0), at(0, 9, 0)};
  CHECK(touches(segment, 5, triangle, 0, solid));
  CHECK(touches(triangle, 0, segment, 5, solid));
  CHECK_FALSE(touches(segment, 2, triangle, rational(29, 10), solid));
}

TEST_CASE("convex: surfaces touch when they share a point, tangent inside or outside, but not when nested") {
  using enum touch_mode;
  const hull a = {at(0, 0, 0)}, b = {at(2, -1, 2)}; // distance 3
  CHECK(touches(a, 1, b, 2, surface));              // tangent outside
  CHECK(touches(a, 5, b, 2, surface));              // tangent inside
  CHECK(touches(a, 2, b, 5, surface));
  CHECK(touches(a, 4, b, 2, surface));
  CHECK_FALSE(touches(a, 6, b, 2, surface)); // nested
  CHECK(touches(a, 6, b, 2, solid));
  CHECK_FALSE(touches(a, 1, b, 1, surface)); // apart
  CHECK(touches(a, 2, a, 2, surface));       // identical
  CHECK_FALSE(touches(a, 2, a, 3, surface)); // concentric
  CHECK(touches(a, 3, b, 0, surface));       // a point on the surface
  CHECK_FALSE(touches(a, 4, b, 0, surface));
  const hull triangle = {at(1, 0, 0), at(0, 2, 0), at(0, 0, 3)}; // least distance² 36/49, greatest 9
  CHECK(squared_distance(a, triangle) == rational(36, 49));
  CHECK(touches(a, rational(6, 7), triangle, 0, surface));
  CHECK_FALSE(touches(a, rational(5, 7), triangle, 0, surface));
  CHECK(touches(a, 3, triangle, 0, surface));
  CHECK_FALSE(touches(a, rational(31, 10), triangle, 0, surface)); // the triangle inside the ball
  CHECK(touches(triangle, 0, a, 3, surface));
  CHECK_FALSE(touches(triangle, 0, a, 4, surface));
  CHECK(touches(triangle, 0, triangle, 0, surface));
}

TEST_CASE("convex: bad input is refused") {
  using enum touch_mode;
  const hull a = {at(0, 0, 0)}, s = {at(0, 0, 0), at(1, 0, 0)};
  CHECK_THROWS_AS(squared_distance({}, a), std::invalid_argument);
  CHECK_THROWS_AS(max_squared_distance(at(0, 0), {}), std::invalid_argument);
  CHECK_THROWS_AS(touches(a, -1, a, 0, solid), std::invalid_argument);
  CHECK_THROWS_AS(touches(s, 1, a, 0, surface), std::invalid_argument);
  CHECK_THROWS_AS(squared_distance(hull(17, at(0, 0)), a), std::invalid_argument);
}
