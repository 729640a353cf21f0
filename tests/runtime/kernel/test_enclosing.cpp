// Enclosing balls: every point of the hull with its pad lies inside, in exact rationals, and the balls are not much too
// large.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/runtime/kernel/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace meetc::matrix_test;
using meetc::generated_test::effort;

namespace {

template <class Shape> bool holds(const double ball[4], const float *row) {
  mpq_class left = ball[3];
  if constexpr (Shape::pad >= 0)
    left -= mpq_class(static_cast<double>(row[Shape::pad]));
  if (left < 0)
    return false;
  for (int p = 0; p < Shape::hull; ++p) {
    mpq_class d2 = 0;
    for (int k = 0; k < 3; ++k) {
      const mpq_class d = mpq_class(meetc::hull_point<Shape>(row, p, k)) - mpq_class(ball[k]);
      d2 += d * d;
    }
    if (d2 > mpq_class(left * left))
      return false;
  }
  return true;
}

template <class Shape> bool holds_all(const float *row) {
  double ball[4];
  meetc::enclosing_ball<Shape>(row, ball);
  return holds<Shape>(ball, row);
}

// Whether the corners of the element's box lie in the ball.
template <class Shape> bool holds_box(const double ball[4], const float *row) {
  float lo[3], hi[3];
  Shape::box(row, lo, hi);
  mpq_class d2 = 0;
  for (int k = 0; k < 3; ++k) {
    const mpq_class to_low = mpq_class(ball[k]) - mpq_class(static_cast<double>(lo[k])),
                    to_high = mpq_class(static_cast<double>(hi[k])) - mpq_class(ball[k]);
    const mpq_class most = to_low < to_high ? to_high : to_low;
    d2 += most * most;
  }
  return d2 <= mpq_class(mpq_class(ball[3]) * ball[3]);
}
template <class Shape> bool box_is_finite(const float *row) {
  float lo[3], hi[3];
  Shape::box(row, lo, hi);
  bool finite = true;
  for (int k = 0; k < 3; ++k)
    finite = finite && std::isfinite(lo[k]) && std::isfinite(hi[k]);
  return finite;
}

constexpr float extremes[] = {0.0F,
                              -0.0F,
                              0x1p-149F,
                              -0x1p-149F,
                              0x1p-126F,
                              0x1.fffffcp-127F,
                              1.0F,
                              -1.0F,
                              0x1.8p-1F,
                              16777217.F,
                              1e-20F,
                              -1e20F,
                              1e6F,
                              1000000.06F,
                              3.4e38F,
                              -3.4e38F,
                              std::numeric_limits<float>::max(),
                              -std::numeric_limits<float>::max()};

float number(std::mt19937_64 &random, int family) {
  const auto real = [&] {
    return static_cast<double>(static_cast<std::int64_t>(random() >> 11) - (1LL << 52)) * 0x1p-52;
  };
  switch (family % 5) {
  case 0:
    return extremes[random() % std::size(extremes)];
  case 1:
    return static_cast<float>(std::ldexp(real(), -140)); // few bits: subnormal
  case 2:
    return static_cast<float>(1e7 + real());
  case 3:
    return static_cast<float>(std::ldexp(real(), static_cast<int>(random() % 276) - 149));
  default:
    return static_cast<float>(real());
  }
}

template <class Shape> void make(std::mt19937_64 &random, int family, float *row) {
  std::generate_n(row, Shape::fields, [&] { return number(random, family); });
  if constexpr (Shape::hull > 1) // needles and points
    if (random() % 4 == 0)
      std::copy_n(row, 3, row + 3);
  if constexpr (Shape::pad >= 0)
    row[Shape::pad] = std::fabs(row[Shape::pad]);
}

template <class Shape> void each_holds(const char *name) {
  std::mt19937_64 random(17);
  long wrong = 0;
  for (int i = 0; i < effort(100000); ++i) {
    float row[Shape::fields];
    make<Shape>(random, i, row);
    wrong += !holds_all<Shape>(row);
  }
  INFO(name);
  CHECK(wrong == 0);
}

// The ball holds the element, or its box, where that is finite.
template <class Shape> void balls_hold(const char *name) {
  std::mt19937_64 random(29);
  long wrong = 0, refused = 0, wrongly_told = 0;
  for (int i = 0; i < effort(50000); ++i) {
    float row[Shape::fields];
    make<Shape>(random, random() % 8 ? 1 + i % 4 : 0, row); // few at the ends of float32
    const bool finite = box_is_finite<Shape>(row);
    wrongly_told += meetc::has_finite_box<Shape>(row) != finite;
    refused += !finite;
    for (const meetc::cover c : {meetc::cover::element, meetc::cover::box}) {
      if (!finite)
        break;
      double ball[4];
      meetc::ball_around<Shape>(c, row, ball);
      wrong += c == meetc::cover::box ? !holds_box<Shape>(ball, row) : !holds<Shape>(ball, row);
    }
  }
  INFO(name << ": " << refused << " refused");
  CHECK(wrong == 0);
  CHECK(wrongly_told == 0);
  CHECK((Shape::pad >= 0) == (refused > 0)); // the box of points never overflows
}

// The radius of the least ball around a triangle: half its longest side where it is obtuse, else its circumradius.
double least_radius(const float *row) {
  long double side[3]; // squared
  for (int i = 0; i < 3; ++i) {
    side[i] = 0;
    for (int k = 0; k < 3; ++k) {
      const long double d =
          static_cast<long double>(row[3 * i + k]) - static_cast<long double>(row[(3 * i + 3) % 9 + k]);
      side[i] += d * d;
    }
  }
  std::sort(side, side + 3);
  if (side[0] + side[1] <= side[2])
    return static_cast<double>(std::sqrt(side[2]) / 2);
  const long double dot = (side[0] + side[1] - side[2]) / 2,
                    area2 = side[0] * side[1] - dot * dot; // (twice the area)^2
  return static_cast<double>(std::sqrt(side[0] * side[1] * side[2] / area2) / 2);
}

} // namespace

TEST_CASE("enclosing balls hold their elements, also at the ends of float32") {
  each_holds<cga::point_shape>("point");
  each_holds<cga::sphere_shape>("sphere");
  each_holds<cga::segment_shape>("segment");
  each_holds<cga::triangle_shape>("triangle");
}

TEST_CASE("an object's ball holds all of its elements or boxes where no box overflows, and which do is told") {
  balls_hold<cga::point_shape>("point");
  balls_hold<cga::sphere_shape>("sphere");
  balls_hold<cga::segment_shape>("segment");
  balls_hold<cga::triangle_shape>("triangle");
}

TEST_CASE("a triangle's enclosing ball is a few per cent larger than the least, seldom more") {
  std::mt19937_64 random(19);
  double worst = 0, sum = 0, least = 2;
  const int n = effort(100000);
  for (int i = 0; i < n; ++i) {
    float row[9];
    for (float &v : row)
      v = number(random, 4);
    double ball[4];
    meetc::enclosing_ball<cga::triangle_shape>(row, ball);
    const double ratio = ball[3] / least_radius(row);
    worst = std::max(worst, ratio), least = std::min(least, ratio), sum += ratio;
  }
  INFO("mean " << sum / n << ", worst " << worst << ", least " << least);
  CHECK(least > 1 - 1e-9); // the judge's own rounding
  CHECK(worst < 1.15);
  CHECK(sum / n < 1.04);
}

TEST_CASE("segments and spheres have their least ball, but for the rounding up") {
  std::mt19937_64 random(23);
  for (int i = 0; i < effort(10000); ++i) {
    float row[6];
    for (float &v : row)
      v = number(random, 4);
    double ball[4], d2 = 0;
    meetc::enclosing_ball<cga::segment_shape>(row, ball);
    for (int k = 0; k < 3; ++k)
      d2 += std::pow(static_cast<double>(row[k]) - static_cast<double>(row[3 + k]), 2);
    REQUIRE(ball[3] <= std::sqrt(d2) / 2 * (1 + 1e-13));
    row[3] = std::fabs(row[3]);
    meetc::enclosing_ball<cga::sphere_shape>(row, ball);
    REQUIRE(ball[3] <= static_cast<double>(row[3]) * (1 + 1e-13));
  }
}
