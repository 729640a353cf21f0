// E4, E5: the sign of B² against plain Euclidean geometry, for the pairs with circles and point pairs. On a
// lattice, so that touching, coplanar and cospherical instances occur.
#include "tests/catch.hpp"
#include "tests/paper/cga.hpp"

using namespace meetc::paper_test;
using meetc::oracle::is_zero;

namespace {

constexpr int instances = 400;
constexpr int limit = 3;

bool saw_all(const sign_counts &c) {
  return c.negative > 20 && c.none > 5 && c.positive > 20;
}

struct pair_sample {
  vec p, q;
  multivector blade;
};
pair_sample random_pair(random_numbers &r) {
  for (;;) {
    const vec p = lattice_vec(r, limit), q = lattice_vec(r, limit);
    if (!zero(q - p))
      return {p, q, point_pair(p, q)};
  }
}
struct plane_sample {
  vec p, normal;
  multivector blade;
};
plane_sample random_plane(random_numbers &r) {
  const lattice_circle c = random_circle(r, limit);
  return {c.p, cross(c.q - c.p, c.s - c.p), plane(c.p, c.q, c.s)};
}

// Whether two circles share a sphere or a plane: their six points span at most four dimensions.
bool cospherical(const lattice_circle &a, const lattice_circle &b) {
  const vec points[3] = {b.p, b.q, b.s};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j)
      if (!is_zero(outer({a.blade, point(points[i]), point(points[j])})))
        return false;
  return true;
}

// Circle b against the disk of a, in plain geometry: −1 linked (b passes once through the disk), 0 b touches
// circle a, +1 neither. Without roots: b meets a's plane in q ± √h u/|u|; their powers about circle a are A ±
// √h D.
int linking(const circle_shape &a, const circle_shape &b) {
  const vec u = cross(a.normal, b.normal);
  if (zero(u))
    return 1; // parallel planes
  const vec w = a.centre - b.centre;
  // q: the point of the planes' line next to b's centre, within b's plane along b.normal × u.
  const vec along = cross(b.normal, u);
  const vec q = b.centre + rational(dot(a.normal, w) / dot(a.normal, along)) * along;
  const rational h = b.squared_radius - square(q - b.centre);
  const rational power = square(q - a.centre) + h - a.squared_radius;
  if (h < 0)
    return 1; // b does not reach the plane
  const rational d = dot(q - a.centre, u);
  return sgn(rational(power * power - 4 * h * d * d / square(u)));
}

} // namespace

TEST_CASE("circle-plane: the paper's criterion holds") {
  random_numbers r(1);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const lattice_circle c = random_circle(r, limit);
    const plane_sample p = random_plane(r);
    const circle_shape &s = c.shape;
    const rational h = dot(p.normal, s.centre - p.p);
    const int truth = sgn(rational(s.squared_radius * square(cross(s.normal, p.normal)) - h * h * square(s.normal)));
    CHECK(sgn(norm2(meet(p.blade, c.blade))) == truth);
    const bool contained = h == 0 && zero(cross(s.normal, p.normal));
    CHECK(is_zero(meet(p.blade, c.blade)) == contained);
    seen.add(truth);
  }
  CHECK(saw_all(seen));
}

TEST_CASE("circle-sphere: the paper's criterion holds") {
  random_numbers r(2);
  sign_counts seen;
  int on_sphere = 0;
  for (int t = 0; t < instances; ++t) {
    const lattice_circle c = random_circle(r, limit);
    const circle_shape &s = c.shape;
    // One in ten passes through the whole circle, one in ten through a point of it.
    const bool through = t % 10 == 0;
    const vec centre = through ? s.centre + rational(r.integer(-1, 1)) * s.normal : lattice_vec(r, limit);
    const rational rr = t % 10 < 2 ? square(c.p - centre) : rational(r.integer(0, 6));
    // The sphere cuts the circle's plane in a circle (perhaps imaginary) of squared radius rr − h².
    const rational m = dot(s.normal, centre - s.centre), hh = m * m / square(s.normal);
    const rational dd = square(centre - s.centre) - hh, rest = dd - s.squared_radius - (rr - hh);
    const int truth = sgn(rational(4 * s.squared_radius * (rr - hh) - rest * rest));
    CHECK(sgn(norm2(meet(centred_sphere(centre, rr), c.blade))) == truth);
    const bool contained = dd == 0 && rr - hh == s.squared_radius;
    CHECK(is_zero(meet(centred_sphere(centre, rr), c.blade)) == contained);
    on_sphere += contained;
    seen.add(truth);
  }
  CHECK(saw_all(seen));
  CHECK(on_sphere > 30);
}

TEST_CASE("E4: circle-line is reversed: < 0 pierces the disk, 0 meets the circle, > 0 passes by") {
  random_numbers r(3);
  sign_counts seen;
  int coplanar = 0;
  for (int t = 0; t < instances; ++t) {
    const lattice_circle c = random_circle(r, limit);
    const pair_sample l = random_pair(r);
    const multivector b = meet(c.blade, line(l.p, l.q));
    const vec v = l.q - l.p;
    const rational slope = dot(c.shape.normal, v), height = dot(c.shape.normal, c.shape.centre - l.p);
    CHECK(is_zero(b) == (slope == 0 && height == 0)); // in the circle's plane: B = 0 says no more
    if (is_zero(b)) {
      ++coplanar;
      continue;
    }
    int truth = 1; // parallel to the plane
    if (slope != 0) {
      const vec x = l.p + rational(height / slope) * v;
      truth = sgn(rational(square(x - c.shape.centre) - c.shape.squared_radius));
    }
    CHECK(sgn(norm2(b)) == truth);
    seen.add(truth);
  }
  CHECK(saw_all(seen));
  CHECK(coplanar > 5);
}

TEST_CASE("E4: circle-circle is reversed: < 0 linked, 0 touching, > 0 neither, B = 0 on one sphere or plane") {
  random_numbers r(4);
  sign_counts seen;
  int together = 0;
  for (int t = 0; t < instances; ++t) {
    const lattice_circle a = random_circle(r, limit), c = random_circle(r, limit);
    const multivector b = meet(a.blade, c.blade);
    CHECK(is_zero(b) == cospherical(a, c));
    if (is_zero(b)) {
      ++together;
      continue;
    }
    const int truth = linking(a.shape, c.shape);
    CHECK(linking(c.shape, a.shape) == truth);
    CHECK(sgn(norm2(b)) == truth);
    seen.add(truth);
  }
  CHECK(saw_all(seen));
  CHECK(together > 5);
}

TEST_CASE("E4: point pair-plane is reversed: < 0 separated, 0 one point on it, > 0 one side, B = 0 both on it") {
  random_numbers r(5);
  sign_counts seen;
  int both = 0;
  for (int t = 0; t < instances; ++t) {
    const pair_sample x = random_pair(r);
    const plane_sample p = random_plane(r);
    const multivector b = meet(p.blade, x.blade);
    const rational first = dot(p.normal, x.p - p.p), second = dot(p.normal, x.q - p.p);
    CHECK(sgn(norm2(b)) == sgn(rational(first * second)));
    CHECK(is_zero(b) == (first == 0 && second == 0));
    both += is_zero(b);
    seen.add(sgn(rational(first * second)));
  }
  CHECK(saw_all(seen));
  CHECK(both > 5);
}

TEST_CASE("E4: point pair-sphere is reversed: < 0 one inside and one outside, B = 0 both on it") {
  random_numbers r(6);
  sign_counts seen;
  int both = 0;
  for (int t = 0; t < instances; ++t) {
    const pair_sample x = random_pair(r);
    const vec c = lattice_vec(r, limit);
    const rational rr = t % 4 == 0 ? square(x.p - c) : rational(r.integer(0, 8));
    const multivector b = meet(centred_sphere(c, rr), x.blade);
    const rational first = square(x.p - c) - rr, second = square(x.q - c) - rr;
    CHECK(sgn(norm2(b)) == sgn(rational(first * second)));
    CHECK(is_zero(b) == (first == 0 && second == 0));
    both += is_zero(b);
    seen.add(sgn(rational(first * second)));
  }
  CHECK(saw_all(seen));
  CHECK(both > 5);
}

TEST_CASE("E5: point pair-line and point pair-circle: B is a number, so B^2 is never negative") {
  random_numbers r(7);
  int coplanar = 0, cosphere = 0, apart = 0;
  for (int t = 0; t < instances; ++t) {
    const pair_sample x = random_pair(r), l = random_pair(r);
    const multivector b = meet(line(l.p, l.q), x.blade);
    CHECK(b == algebra().scalar(b[0]));
    const bool flat = det(x.p - l.p, x.q - l.p, l.q - l.p) == 0;
    CHECK((norm2(b) == 0) == flat);
    CHECK(norm2(b) >= 0);
    coplanar += flat;
    const lattice_circle c = random_circle(r, limit);
    const multivector d = meet(c.blade, x.blade);
    CHECK(d == algebra().scalar(d[0]));
    const bool on_sphere = is_zero(outer({c.blade, x.blade}));
    CHECK((norm2(d) == 0) == on_sphere);
    cosphere += on_sphere;
    apart += !on_sphere && !flat;
  }
  CHECK(coplanar > 20);
  CHECK(cosphere > 20);
  CHECK(apart > 20);
}

TEST_CASE("E4: flat point-plane: B^2 is identically 0, B = s n, flat point-sphere is reversed") {
  random_numbers r(8);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const vec x = lattice_vec(r, limit), c = lattice_vec(r, limit);
    const plane_sample p = random_plane(r);
    const multivector b = meet(p.blade, flat_point(x));
    CHECK(b == rational(16 * dot(p.normal, x - p.p)) * n());
    CHECK(norm2(b) == 0);
    // With a sphere it is the pair of x and infinity: < 0 where the sphere parts them.
    const rational rr = r.integer(0, 8), power = square(x - c) - rr;
    CHECK(sgn(norm2(meet(centred_sphere(c, rr), flat_point(x)))) == sgn(power));
    seen.add(sgn(power));
  }
  CHECK(saw_all(seen));
}
