// E4, E5: the sign of B² against plain Euclidean geometry, for the pairs with planes, lines and spheres.
// Half of the instances lie on a small lattice, so that tangent, parallel and identical ones occur.
#include "tests/catch.hpp"
#include "tests/paper/cga.hpp"

using namespace meetc::paper_test;

namespace {

constexpr int instances = 400;

vec some_vec(random_numbers &r, int t) {
  return t % 2 != 0 ? random_vec(r, 4) : lattice_vec(r, 2);
}

struct plane_sample {
  vec p, normal;
  multivector blade;
};
plane_sample some_plane(random_numbers &r, int t) {
  for (;;) {
    const vec p = some_vec(r, t), q = some_vec(r, t), s = some_vec(r, t), normal = cross(q - p, s - p);
    if (!zero(normal))
      return {p, normal, plane(p, q, s)};
  }
}
plane_sample on_lattice(random_numbers &r, int limit) {
  const lattice_circle c = random_circle(r, limit);
  return {c.p, c.shape.normal, plane(c.p, c.q, c.s)};
}
struct line_sample {
  vec p, v;
  multivector blade;
};
line_sample some_line(random_numbers &r, int t) {
  for (;;) {
    const vec p = some_vec(r, t), q = some_vec(r, t);
    if (!zero(q - p))
      return {p, q - p, line(p, q)};
  }
}

bool saw_all(const sign_counts &c) {
  return c.negative > 20 && c.none > 5 && c.positive > 20;
}

} // namespace

TEST_CASE("E4: sphere-sphere: > 0 cut, 0 tangent, < 0 disjoint or nested, B^2 has two factors") {
  random_numbers r(1);
  sign_counts seen;
  int nested = 0, disjoint = 0;
  for (int t = 0; t < instances; ++t) {
    const vec c = some_vec(r, t), d = some_vec(r, t);
    const rational r1 = r.fraction(3), r2 = r.integer(0, 3), gap = square(c - d);
    const rational outside = gap - (r1 + r2) * (r1 + r2), inside = gap - (r1 - r2) * (r1 - r2);
    const multivector b = meet(centred_sphere(c, r1 * r1), centred_sphere(d, r2 * r2));
    const rational b2 = norm2(b);
    CHECK(meetc::oracle::is_zero(b) == (gap == 0 && r1 * r1 == r2 * r2));
    CHECK(b2 == -4 * outside * inside);
    // |r1 − r2| < d < r1 + r2, with r1 of any sign here.
    const rational sum = abs(r1) + r2, difference = abs(r1) - r2;
    const bool cut = gap < sum * sum && gap > difference * difference;
    const bool tangent = gap == sum * sum || gap == difference * difference;
    CHECK(sgn(b2) == (cut ? 1 : tangent ? 0 : -1));
    seen.add(sgn(b2));
    nested += gap < difference * difference;
    disjoint += gap > sum * sum;
  }
  CHECK(saw_all(seen));
  CHECK(nested > 20); // E4: the criterion says "do not intersect", yet one ball lies in the other
  CHECK(disjoint > 20);
}

TEST_CASE("E4: sphere-sphere from four points each has the same sign as from centre and radius") {
  random_numbers r(2);
  for (int t = 0; t < 200; ++t) {
    rational squared_radius[2];
    vec centre[2];
    multivector blade[2];
    for (int i = 0; i < 2; ++i) {
      vec p, a, b, c;
      rational k = 0;
      while (k == 0) {
        p = some_vec(r, t);
        a = some_vec(r, t) - p;
        b = some_vec(r, t) - p;
        c = some_vec(r, t) - p;
        k = det(a, b, c);
      }
      const vec v = square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b);
      centre[i] = p + rational(1 / (2 * k)) * v;
      squared_radius[i] = square(v) / (4 * k * k);
      blade[i] = sphere(p, p + a, p + b, p + c);
    }
    // 4 r1² r2² − (r1² + r2² − d²)² has the sign of −(d² − (r1 + r2)²)(d² − (r1 − r2)²), without a root.
    const rational s = squared_radius[0] + squared_radius[1] - square(centre[0] - centre[1]);
    CHECK(sgn(norm2(meet(blade[0], blade[1]))) == sgn(rational(4 * squared_radius[0] * squared_radius[1] - s * s)));
  }
}

TEST_CASE("plane-sphere: the paper's criterion holds") {
  random_numbers r(3);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const plane_sample p = some_plane(r, t);
    const vec c = some_vec(r, t);
    const rational rr = r.integer(0, 4), h = dot(p.normal, c - p.p);
    const int truth = sgn(rational(rr * square(p.normal) - h * h));
    CHECK(sgn(norm2(meet(centred_sphere(c, rr), p.blade))) == truth);
    CHECK(sgn(norm2(meet(p.blade, centred_sphere(c, rr)))) == truth);
    seen.add(truth);
  }
  CHECK(saw_all(seen));
}

TEST_CASE("line-sphere: the paper's criterion holds") {
  random_numbers r(4);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const line_sample l = some_line(r, t);
    const vec c = some_vec(r, t);
    const rational rr = r.integer(0, 3);
    const int truth = sgn(rational(rr * square(l.v) - square(cross(c - l.p, l.v))));
    CHECK(sgn(norm2(meet(centred_sphere(c, rr), l.blade))) == truth);
    seen.add(truth);
  }
  CHECK(saw_all(seen));
}

TEST_CASE("E5: line-plane: B^2 is never negative, and 0 only says parallel, B = 0 says contained") {
  random_numbers r(5);
  int parallel = 0, contained = 0;
  for (int t = 0; t < instances; ++t) {
    const line_sample l = some_line(r, t);
    const plane_sample p = some_plane(r, t);
    const multivector b = meet(p.blade, l.blade);
    const rational slope = dot(p.normal, l.v);
    CHECK(norm2(b) == 1024 * slope * slope);
    const bool inside = slope == 0 && dot(p.normal, l.p - p.p) == 0;
    CHECK(meetc::oracle::is_zero(b) == inside);
    contained += inside;
    parallel += slope == 0 && !inside;
  }
  CHECK(parallel > 20);
  CHECK(contained > 5);
}

TEST_CASE("E5: plane-plane: B^2 is never negative, and 0 only says parallel, B = 0 says identical") {
  random_numbers r(6);
  int parallel = 0, identical = 0;
  for (int t = 0; t < instances; ++t) {
    const plane_sample p = on_lattice(r, 1 + t % 2), q = on_lattice(r, 1 + t % 2);
    const multivector b = meet(p.blade, q.blade);
    const vec u = cross(p.normal, q.normal);
    CHECK(norm2(b) == 4096 * square(u));
    const bool same = zero(u) && dot(p.normal, q.p - p.p) == 0;
    CHECK(meetc::oracle::is_zero(b) == same);
    identical += same;
    parallel += zero(u) && !same;
  }
  CHECK(parallel > 5);
  CHECK(identical > 5);
}

TEST_CASE("E4: line-line: B^2 is identically 0, B = s n with s 16 times a triple product") {
  random_numbers r(7);
  int coplanar = 0;
  for (int t = 0; t < instances; ++t) {
    const line_sample k = some_line(r, t), l = some_line(r, t);
    const multivector b = meet(k.blade, l.blade);
    const rational s = 16 * det(l.p - k.p, k.v, l.v);
    CHECK(b == s * n());
    CHECK(norm2(b) == 0);
    coplanar += s == 0;
  }
  CHECK(coplanar > 20);
  CHECK(coplanar < instances - 20);
}

TEST_CASE("point-plane: B is a number, the side test, B^2 says nothing") {
  random_numbers r(8);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const plane_sample p = some_plane(r, t);
    const vec x = some_vec(r, t);
    const multivector b = meet(p.blade, point(x));
    const rational side = 16 * dot(p.normal, x - p.p);
    CHECK(b == algebra().scalar(side));
    seen.add(sgn(side));
  }
  CHECK(saw_all(seen));
}

TEST_CASE("point-sphere: B is a number, positive inside, 0 on the sphere, negative outside") {
  random_numbers r(9);
  sign_counts seen;
  for (int t = 0; t < instances; ++t) {
    const vec c = some_vec(r, t), x = some_vec(r, t);
    const rational rr = r.integer(0, 5), power = square(x - c) - rr;
    CHECK(meet(centred_sphere(c, rr), point(x)) == algebra().scalar(-2 * power));
    seen.add(sgn(power));
  }
  CHECK(saw_all(seen));
}
