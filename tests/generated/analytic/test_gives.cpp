// The geometry that emitted readings give back: the stored numbers of elements, and the geometry of meets, against 200 bits.
#include "gen/oracle/dense.hpp"
#include "tests/catch.hpp"
#include "tests/generated/analytic/wide.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <given/given.hpp>
#include <limits>
#include <random>

using namespace meetc::generated_test;
namespace oracle = meetc::oracle;

namespace {

class source {
public:
  explicit source(unsigned seed) : random_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  double size(double from, double to) { return std::pow(10, between(from, to)); }
  template <class T> given::point<T> point(double far) {
    return {T(far * between(-1, 1)), T(far * between(-1, 1)), T(far * between(-1, 1))};
  }
  template <class T> given::direction<T> direction(double long_) {
    const given::point<double> p = point<double>(1);
    const double l = std::hypot(p.x, p.y, p.z) + 1e-3;
    return {T(long_ * p.x / l), T(long_ * p.y / l), T(long_ * (p.z + 1e-3) / l)};
  }

private:
  std::mt19937 random_;
};

// The worst error as a part of what docs/numerics.md states.
struct worst {
  const char *what;
  double seen = 0;
  explicit worst(const char *name) : what(name) {}
  ~worst() { std::printf("%-48s at most %.2f of what is stated\n", what, seen); }
  void hold(const wide &error, const wide &stated) {
    const auto part = error == wide(0) ? 0 : static_cast<double>(error / stated);
    seen = part > seen ? part : seen;
    CHECK(part <= 1);
  }
};

template <class V> wide length(const V &v) {
  return sqrt(wide(v.x) * wide(v.x) + wide(v.y) * wide(v.y) + wide(v.z) * wide(v.z));
}
template <class V, class W> wide distance(const V &a, const W &b) {
  return length(given::point<wide>{wide(a.x) - wide(b.x), wide(a.y) - wide(b.y), wide(a.z) - wide(b.z)});
}
wide square(const wide &x) {
  return x * x;
}

// The same blade in 200 bits: its coefficients, which are all of one type.
template <template <class> class Blade, class T> Blade<wide> widened(const Blade<T> &b) {
  constexpr std::size_t n = sizeof(Blade<T>) / sizeof(T);
  const T *from = reinterpret_cast<const T *>(&b);
  Blade<wide> out;
  wide *to = reinterpret_cast<wide *>(&out);
  for (std::size_t i = 0; i < n; ++i)
    to[i] = wide(from[i]);
  return out;
}
template <template <class> class Blade, class T> Blade<T> scaled(Blade<T> b, double by) {
  T *at = reinterpret_cast<T *>(&b);
  for (std::size_t i = 0; i < sizeof b / sizeof(T); ++i)
    at[i] *= T(by);
  return b;
}

template <class T> void check_readings(const std::string &type) {
  const std::string names[] = {"point, " + type,
                               "sphere, centre, " + type,
                               "sphere, radius^2, " + type,
                               "plane, " + type,
                               "line, " + type,
                               "circle, centre, " + type,
                               "circle, normal, " + type,
                               "circle, radius^2, " + type,
                               "point pair, middle, " + type,
                               "point pair, distance^2, " + type,
                               "flat point, " + type};
  std::vector<worst> all;
  all.reserve(std::size(names));
  for (const std::string &name : names)
    all.emplace_back(name.c_str());
  const wide u(std::numeric_limits<T>::epsilon() / 2);
  source random(5);
  for (int i = 0; i < 4000; ++i) {
    const double far = random.size(-3, 3), scale = (i % 2 ? 1 : -1) * random.size(-2, 2);
    {
      const auto blade_of = scaled(blade(random.point<T>(far)), scale);
      const auto want = gives(widened(blade_of));
      all[0].hold(distance(gives(blade_of).centre, want.centre), wide(2) * u * length(want.centre));
    }
    {
      const given::sphere<T> s{random.point<T>(far), T(far * random.size(-3, 3))};
      const auto b = scaled(blade(s), scale);
      const auto have = gives(b);
      const auto want = gives(widened(b));
      CHECK((have.exists && want.exists && want.is_real));
      all[1].hold(distance(have.centre, want.centre), wide(4) * u * length(want.centre));
      all[2].hold(abs(square(wide(have.radius)) - square(want.radius)),
                  wide(8) * u * (square(length(want.centre)) + square(want.radius)));
    }
    {
      const auto b = scaled(blade(given::plane<T>{random.direction<T>(random.size(-2, 2)), T(far)}), scale);
      const auto have = gives(b);
      const auto want = gives(widened(b));
      all[3].hold(distance(have.normal, want.normal), wide(6) * u);
      all[3].hold(abs(wide(have.offset) - want.offset), wide(6) * u * abs(want.offset));
    }
    {
      const auto p = random.point<T>(far), q = random.point<T>(far);
      const auto b = scaled(blade(given::line<T>{p, q}), scale);
      const auto have = gives(b);
      const auto want = gives(widened(b));
      all[4].hold(distance(have.along, want.along), wide(6) * u);
      all[4].hold(distance(have.foot, want.foot), wide(16) * u * length(want.foot));
    }
    {
      const given::circle<T> c{random.point<T>(far), random.direction<T>(random.size(-2, 2)),
                               T(far * random.size(-3, 3))};
      const auto b = scaled(blade(c), scale);
      const auto have = gives(b);
      const auto want = gives(widened(b));
      CHECK((have.exists && want.exists));
      const wide size = square(length(want.centre)) + square(want.radius);
      all[5].hold(distance(have.centre, want.centre), wide(8) * u * length(want.centre));
      all[6].hold(distance(have.normal, want.normal), wide(6) * u);
      if (want.is_real)
        all[7].hold(abs(square(wide(have.radius)) - square(want.radius)), wide(16) * u * size);
    }
    {
      const auto p = random.point<T>(far);
      given::point<T> q = random.point<T>(far * random.size(-4, 0));
      q.x += p.x;
      const auto b = scaled(blade(given::point_pair<T>{p, q}), scale);
      const auto have = gives(b);
      const auto want = gives(widened(b));
      CHECK((have.exists && std::isfinite(have.p.x) && std::isfinite(have.q.z)));
      const auto middle = [](const auto &g) {
        return given::point<wide>{wide(g.p.x) + wide(g.q.x), wide(g.p.y) + wide(g.q.y), wide(g.p.z) + wide(g.q.z)};
      };
      const wide size = square(length(want.p)) + square(length(want.q)), apart = distance(want.p, want.q);
      all[8].hold(distance(middle(have), middle(want)), wide(8) * u * size / apart);
      all[9].hold(abs(square(distance(have.p, have.q)) - square(apart)), wide(32) * u * size);
    }
    {
      const auto b = scaled(blade(given::flat_point<T>{random.point<T>(far)}), scale);
      const auto want = gives(widened(b));
      all[10].hold(distance(gives(b).place, want.place), wide(4) * u * length(want.place));
    }
  }
}

} // namespace

TEST_CASE("blades give back the stored numbers, at any scale and with either sign") {
  source random(4);
  for (const double scale : {1.0, -3.0, 0.125}) {
    const given::sphere<double> s{{1, -2, 3}, 5};
    const auto sphere = gives(scaled(blade(s), scale));
    CHECK((sphere.centre.x == 1 && sphere.centre.y == -2 && sphere.centre.z == 3 && sphere.radius == 5));
    CHECK((sphere.exists && sphere.is_real));
    const auto plane = gives(scaled(blade(given::plane<double>{{0, 3, -4}, 10}), scale));
    const double way = scale < 0 ? -1 : 1;
    CHECK(plane.normal.y * way == Approx(0.6));
    CHECK(plane.offset * way == Approx(2));
    const auto line = gives(scaled(blade(given::line<double>{{1, 0, 2}, {1, 3, 2}}), scale));
    CHECK(line.along.y * way == Approx(1));
    CHECK((line.foot.x == Approx(1) && line.foot.y == Approx(0).margin(1e-15) && line.foot.z == Approx(2)));
    const auto circle = gives(scaled(blade(given::circle<double>{{1, 2, 3}, {0, 0, 2}, 0.5}), scale));
    CHECK((circle.centre.x == Approx(1) && circle.centre.y == Approx(2) && circle.centre.z == Approx(3)));
    CHECK(circle.normal.z * way == Approx(1));
    CHECK(circle.radius == Approx(0.5));
    const auto pair = gives(scaled(blade(given::point_pair<double>{{1, 2, 3}, {4, 6, 8}}), scale));
    const auto &first = scale > 0 ? pair.p : pair.q, &second = scale > 0 ? pair.q : pair.p;
    CHECK((first.x == Approx(1) && first.y == Approx(2) && first.z == Approx(3)));
    CHECK((second.x == Approx(4) && second.y == Approx(6) && second.z == Approx(8)));
  }
}

TEST_CASE("readings err by what is stated") {
  check_readings<float>("float");
  check_readings<double>("double");
}

TEST_CASE("the meet of two spheres is read back as the circle that they have in common") {
  source random(6);
  worst centres("meet of spheres, centre"), radii("meet of spheres, radius^2");
  const wide u(std::numeric_limits<double>::epsilon() / 2);
  for (int i = 0; i < 2000; ++i) {
    const given::sphere<double> a{random.point<double>(10), random.between(1, 5)};
    given::sphere<double> b = a;
    const given::direction<double> way = random.direction<double>(random.between(0.5, 9));
    b.c = {a.c.x + way.x, a.c.y + way.y, a.c.z + way.z};
    b.r = random.between(1, 5);
    const wide d = distance(a.c, b.c), r1(a.r), r2(b.r);
    const wide t = (d * d + r1 * r1 - r2 * r2) / (wide(2) * d * d), r = r1 * r1 - t * t * d * d;
    const given::point<wide> centre{wide(a.c.x) + t * (wide(b.c.x) - wide(a.c.x)),
                                    wide(a.c.y) + t * (wide(b.c.y) - wide(a.c.y)),
                                    wide(a.c.z) + t * (wide(b.c.z) - wide(a.c.z))};
    const auto circle = gives(meet(a, b));
    REQUIRE(circle.exists);
    // The blades hold squares of coordinates.
    const wide size = square(length(a.c) + r1) + square(length(b.c) + r2);
    centres.hold(distance(circle.centre, centre), wide(16) * u * size * sqrt(size) / (d * d));
    if (circle.is_real != !(r < wide(0)))
      CHECK(abs(r) < wide(4) * u * size * size / (d * d));
    if (circle.is_real)
      radii.hold(abs(square(wide(circle.radius)) - r), wide(4) * u * size * size / (d * d));
    CHECK(abs(wide(circle.normal.x) * wide(way.y) - wide(circle.normal.y) * wide(way.x)) < wide(1e-12));
  }
}

TEST_CASE("the circle of a meet is that of the dense product") {
  // R(4,1) over e1, e2, e3, n, nb.
  const oracle::dense_algebra space(
      {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 0, 2}, {0, 0, 0, 2, 0}});
  const auto dual_sphere = [&](int x, int y, int z, int r) {
    oracle::multivector s = space.zero();
    s[1] = 2 * x, s[2] = 2 * y, s[4] = 2 * z, s[8] = x * x + y * y + z * z - r * r, s[16] = -1;
    return s;
  };
  // Spheres about (0,0,0) and (8,0,0) with the radii 5 and 5 meet at x = 4, in a circle of radius 3.
  const auto circle = gives(meet(given::sphere<double>{{0, 0, 0}, 5}, given::sphere<double>{{8, 0, 0}, 5}));
  CHECK((circle.centre.x == 4 && circle.centre.y == 0 && circle.centre.z == 0 && circle.radius == 3));
  CHECK(std::fabs(circle.normal.x) == 1);
  // Each of its points is on both spheres, by inner products.
  for (const auto &[y, z] : {std::pair(3, 0), {0, -3}}) {
    oracle::multivector p = dual_sphere(static_cast<int>(circle.centre.x), y, z, 0);
    for (const int x : {0, 8})
      CHECK(oracle::scalar_part(space.geometric(p, dual_sphere(x, 0, 0, 5))) == 0);
  }
}

TEST_CASE("the ends of a tangent pair are one point, and no number is NaN") {
  for (const double off : {0.0, 1e-17, -1e-17, 1e-9, -1e-9}) {
    // A line that touches a sphere, passes it, or cuts it.
    const auto pair =
        gives(meet(given::sphere<double>{{1, 2, 3}, 0.1}, given::line<double>{{0, 2, 3.1 + off}, {5, 2, 3.1 + off}}));
    CHECK(pair.exists);
    for (const auto &end : {pair.p, pair.q}) {
      CHECK(end.x == Approx(1).margin(1e-4));
      CHECK(end.y == Approx(2).margin(1e-12));
      CHECK(end.z == Approx(3.1).margin(1e-8));
    }
    if (!pair.is_real)
      CHECK((pair.p.x == pair.q.x && pair.p.y == pair.q.y && pair.p.z == pair.q.z));
  }
  const auto cut = gives(meet(given::sphere<double>{{0, 0, 0}, 5}, given::line<double>{{-9, 3, 0}, {9, 3, 0}}));
  CHECK(cut.is_real);
  CHECK(std::fabs(cut.p.x) == Approx(4));
  CHECK(cut.p.x == Approx(-cut.q.x));
  CHECK((cut.p.y == Approx(3) && cut.q.y == Approx(3)));
  const auto missed = gives(meet(given::sphere<double>{{0, 0, 0}, 5}, given::line<double>{{-9, 6, 0}, {9, 6, 0}}));
  CHECK((missed.exists && !missed.is_real));
}

TEST_CASE("a meet that is no such element says so, with numbers that are finite") {
  const auto none = gives(meet(given::sphere<double>{{1, 1, 1}, 1}, given::sphere<double>{{1, 1, 1}, 2}));
  CHECK_FALSE(none.exists);
  CHECK((std::isfinite(none.centre.x) && std::isfinite(none.normal.y) && std::isfinite(none.radius)));
  const auto parallel = gives(meet(given::plane<double>{{0, 0, 1}, 1}, given::plane<double>{{0, 0, 1}, 2}));
  CHECK_FALSE(parallel.exists);
  CHECK((std::isfinite(parallel.along.x) && std::isfinite(parallel.foot.z)));
  const auto crossed = gives(meet(given::plane<double>{{0, 0, 1}, 1}, given::plane<double>{{0, 2, 0}, 6}));
  CHECK(crossed.exists);
  CHECK(std::fabs(crossed.along.x) == Approx(1));
  CHECK((crossed.foot.y == Approx(3) && crossed.foot.z == Approx(1)));
}
