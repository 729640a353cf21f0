// A motor is a pose: its matrix moves every kind as V X ~V does, and a set in that pose gives the answers of the
// moved elements.
#include "meet/app/input/motor.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"
#include "tests/catch.hpp"
#include "tests/generated/analytic/wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <planes/planes.hpp>
#include <random>
#include <rigid/rigid.hpp>
#include <rigid/rigid_runtime.hpp>

using namespace meetc::generated_test;

namespace {

class source {
public:
  explicit source(unsigned seed) : random_(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  rigid::point<double> point() { return {number(), number(), number()}; }
  // A motor of any length, with a translation of about `reach`: the exponential of a bivector, scaled.
  rigid::motor_blade<double> motor(double reach = 2) {
    rigid::motor_blade<double> v = exp(
        rigid::bivector<double>{number(), number(), number(), reach * number(), reach * number(), reach * number()});
    double *at = &v.scalar;
    for (std::size_t i = 0; i < sizeof v / sizeof *at; ++i)
      at[i] *= 3;
    return v;
  }

private:
  std::mt19937 random_;
};

rigid::point<double> moved(const double (&m)[12], const rigid::point<double> &p) {
  const double x[] = {p.x, p.y, p.z};
  double out[3];
  for (int i = 0; i < 3; ++i)
    out[i] = m[4 * i] * x[0] + m[4 * i + 1] * x[1] + m[4 * i + 2] * x[2] + m[4 * i + 3];
  return {out[0], out[1], out[2]};
}
rigid::direction<double> turned(const double (&m)[12], const rigid::direction<double> &d) {
  const rigid::point<double> to = moved(m, {d.x, d.y, d.z});
  return {to.x - m[3], to.y - m[7], to.z - m[11]};
}

// The blades are multiples of each other.
template <template <class> class Blade> void check_same(const Blade<double> &a, const Blade<double> &b) {
  const auto *x = reinterpret_cast<const double *>(&a), *y = reinterpret_cast<const double *>(&b);
  constexpr std::size_t n = sizeof a / sizeof *x;
  double size_x = 0, size_y = 0, off = 0;
  for (std::size_t i = 0; i < n; ++i)
    size_x = std::max(size_x, std::fabs(x[i])), size_y = std::max(size_y, std::fabs(y[i]));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      off = std::max(off, std::fabs(x[i] * y[j] - x[j] * y[i]));
  REQUIRE(size_x * size_y > 0);
  CHECK(off < 1e-12 * size_x * size_y);
}

} // namespace

TEST_CASE("the matrix of a motor moves elements of every kind as the motor does") {
  source random(1);
  for (int i = 0; i < 200; ++i) {
    const rigid::motor_blade<double> v = random.motor();
    double m[12];
    pose(v, m);
    const rigid::point<double> p = random.point(), q = random.point();
    const rigid::direction<double> n{random.number(), random.number(), random.number()};
    const double r = random.number(), d = random.number();
    const rigid::direction<double> to = turned(m, n);
    check_same(carried(v, blade(p)), blade(moved(m, p)));
    check_same(carried(v, blade(rigid::sphere<double>{p, r})), blade(rigid::sphere<double>{moved(m, p), r}));
    check_same(carried(v, blade(rigid::line<double>{p, q})), blade(rigid::line<double>{moved(m, p), moved(m, q)}));
    check_same(carried(v, blade(rigid::point_pair<double>{p, q})),
               blade(rigid::point_pair<double>{moved(m, p), moved(m, q)}));
    check_same(carried(v, blade(rigid::circle<double>{p, n, r})), blade(rigid::circle<double>{moved(m, p), to, r}));
    check_same(carried(v, blade(rigid::plane<double>{n, d})),
               blade(rigid::plane<double>{to, d + to.x * m[3] + to.y * m[7] + to.z * m[11]}));
  }
}

TEST_CASE("a set in the pose of a motor gives the answers of the moved elements") {
  source random(2);
  const meetc::predicate_info &touch = meetc::find_predicate(rigid::catalogue(), "ball_ball");
  constexpr int count = 150;
  std::vector<float> a, b;
  for (std::vector<float> *set : {&a, &b})
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k)
        set->push_back(static_cast<float>(random.number()));
      set->push_back(static_cast<float>(0.1 * std::fabs(random.number())));
    }
  const auto prepared = [&](const std::vector<float> &rows, const meetc::pose &at) {
    return meetc::prepare({.data = rows.data(), .stride_bytes = 16, .elements = count}, *touch.b, at);
  };
  std::size_t hits = 0;
  for (int turn = 0; turn < 20; ++turn) {
    const rigid::motor_blade<double> v = random.motor(0.02);
    meetc::pose at;
    pose(v, at.m);
    const meetc::prepared first = prepared(a, {}), second = prepared(b, at);
    const auto found = meetc::collide(first, second, touch, meetc::rung::fp64).pairs;
    hits += found.size();
    for (int j = 0; j < count; ++j) {
      const float *s = &b[4 * static_cast<std::size_t>(j)];
      const auto ball = gives(carried(v, blade(rigid::sphere<double>{{s[0], s[1], s[2]}, s[3]})));
      for (int i = 0; i < count; ++i) {
        const float *t = &a[4 * static_cast<std::size_t>(i)];
        const double gap = std::hypot(ball.centre.x - t[0], ball.centre.y - t[1], ball.centre.z - t[2]) - s[3] - t[3];
        if (std::fabs(gap) < 1e-5) // the pose rounds to float
          continue;
        const bool is_found = std::any_of(found.begin(), found.end(), [&](const meetc::index_pair &pair) {
          return pair.a == static_cast<unsigned>(i) && pair.b == static_cast<unsigned>(j);
        });
        if (is_found != (gap < 0))
          FAIL_CHECK("balls " << i << " and " << j << " with the gap " << gap);
      }
    }
  }
  CHECK(hits > 100);
  // Zero is no versor and has no pose.
  meetc::pose none;
  pose(rigid::motor_blade<double>{}, none.m);
  CHECK_THROWS_AS(prepared(b, none), meetc::input_error);
}

TEST_CASE("the program reads a motor's numbers as the emitted pose does, bit for bit") {
  source random(4);
  for (int i = 0; i < 1000; ++i) {
    std::array<double, 8> v{};
    for (double &x : v)
      x = random.number();
    double want[12];
    planes::pose(planes::motor<double>{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]}, want);
    const std::array<double, 12> have = meetc::app::matrix_of_motor(v);
    REQUIRE(std::equal(have.begin(), have.end(), want));
  }
}
