// Proofs about an element in a pose, without moving it.
#include "tests/catch.hpp"

#include "meet/core/views/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

using namespace meetc;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

// A ball's row.
constexpr role ball_roles[] = {role::x, role::y, role::z, role::length};
constexpr kind_info balls{"ball", "x,y,z,r", 4, ball_roles, 0, nullptr, nullptr};

struct case_of_pose {
  pose at;
  float lo[3], hi[3], longest = 0;
};

// The box around some balls, and a pose.
case_of_pose draw(std::mt19937 &random, std::vector<float> &rows, int scale) {
  std::uniform_real_distribution<double> unit(-1, 1);
  case_of_pose c;
  for (double &m : c.at.m)
    m = unit(random);
  c.at.length_scale = std::abs(unit(random));
  c.at.grid = random() % 4 == 0 ? std::ldexp(1.0, scale - 8) : 0;
  std::fill(c.lo, c.lo + 3, inf), std::fill(c.hi, c.hi + 3, -inf);
  rows.clear();
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 3; ++k)
      rows.push_back(std::ldexp(static_cast<float>(unit(random)), scale));
    const float r = std::ldexp(static_cast<float>(std::abs(unit(random))), scale - 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const float x = rows[rows.size() - 3 + k];
      c.lo[k] = std::min(c.lo[k], std::nextafter(x - r, -inf)), c.hi[k] = std::max(c.hi[k], std::nextafter(x + r, inf));
    }
    rows.push_back(r);
    c.longest = std::max(c.longest, r);
  }
  for (int k = 0; k < 3; ++k)
    c.at.m[4 * k + 3] = std::ldexp(unit(random), scale);
  return c;
}

} // namespace

TEST_CASE("pose: elements proved apart from a box lie outside of it, and distant ones are proved") {
  std::mt19937 random(5);
  std::vector<float> rows;
  constexpr int cases = 20000;
  int proved = 0;
  for (int n = 0; n < cases; ++n) {
    const int scale = std::uniform_int_distribution(-148, 100)(random);
    const case_of_pose c = draw(random, rows, scale);
    double least = HUGE_VAL, greatest = -HUGE_VAL; // of the posed balls along an axis
    const std::size_t axis = random() % 3;
    for (std::size_t i = 0; i < rows.size(); i += 4) {
      float row[4];
      std::copy_n(&rows[i], 4, row);
      move_rows(balls, c.at, row, 1);
      const double x = row[axis], r = row[3];
      least = std::min(least, x - r), greatest = std::max(greatest, x + r);
    }
    // A box that touches the ball that is farthest along the axis, from outside.
    float from[3] = {-inf, -inf, -inf}, to[3] = {inf, inf, inf};
    from[axis] = static_cast<float>(greatest);
    if (static_cast<double>(from[axis]) > greatest)
      from[axis] = std::nextafter(from[axis], -inf);
    CHECK_FALSE(proved_apart(c.at, c.lo, c.hi, static_cast<double>(c.longest), from, to));
    from[axis] = -inf, to[axis] = static_cast<float>(least);
    if (static_cast<double>(to[axis]) < least)
      to[axis] = std::nextafter(to[axis], inf);
    CHECK_FALSE(proved_apart(c.at, c.lo, c.hi, static_cast<double>(c.longest), from, to));
    to[axis] = static_cast<float>(least - std::ldexp(8.0, scale)); // the pose makes nothing larger than that
    proved += proved_apart(c.at, c.lo, c.hi, static_cast<double>(c.longest), from, to);
  }
  CHECK(proved > cases * 9 / 10); // the very small ones are within the slack
}

TEST_CASE("pose: the slack covers a rounding to float32 and to a grid") {
  pose at;
  const float lo[3] = {1, 0, 0}, hi[3] = {1, 0, 0}, to[3] = {2, 1, 1};
  at.m[3] = 0x1p-25; // 1 + 2^-25 becomes 1
  const float beyond[3] = {std::nextafter(1.0F, 2.0F), 0, 0};
  CHECK_FALSE(proved_apart(at, lo, hi, 0, beyond, to));
  const float clear[3] = {1.00001F, 0, 0};
  CHECK(proved_apart(at, lo, hi, 0, clear, to));
  at.grid = 0x1p-3;
  CHECK_FALSE(proved_apart(at, lo, hi, 0, clear, to));
  at.grid = 0;
  CHECK_FALSE(proved_apart(at, lo, hi, 1e-5, clear, to)); // a ball's radius
  at.length_scale = 0.1;
  CHECK(proved_apart(at, lo, hi, 1e-5, clear, to));
}

TEST_CASE("pose: a matrix that keeps the axes") {
  pose at;
  CHECK(keeps_axes(at.m));
  at.m[0] = 2, at.m[5] = 0, at.m[3] = -7;
  CHECK(keeps_axes(at.m));
  for (const auto &[place, value] : {std::pair(0, -1.0), std::pair(0, std::nan("")), std::pair(1, 0x1p-1000),
                                     std::pair(6, std::nan("")), std::pair(10, -0x1p-1000)}) {
    pose other;
    other.m[place] = value;
    CHECK_FALSE(keeps_axes(other.m));
  }
}

#if defined(__SSE2__)
TEST_CASE("pose: flush-to-zero changes no proof") {
  pose at;
  at.m[0] = at.m[5] = at.m[10] = 0x1p130;
  const float lo[3] = {0x1p-129F, 0, 0}, from[3] = {1, 0, 0}, to[3] = {3, 1, 1}; // it goes to 2
  const unsigned found = _mm_getcsr();
  _mm_setcsr(found | 0x8040U);
  const bool apart = proved_apart(at, lo, lo, 0, from, to);
  _mm_setcsr(found);
  CHECK_FALSE(apart);
}
#endif

TEST_CASE("pose: nothing is proved of elements that might leave float32") {
  pose at;
  const float lo[3] = {0, 0, 0}, hi[3] = {1, 1, 1}, from[3] = {5, 5, 5}, to[3] = {6, 6, 6};
  CHECK(proved_apart(at, lo, hi, 0, from, to));
  for (const double m : {1e38, -1e38, 1e300, HUGE_VAL, std::nan("")}) {
    at.m[0] = m;
    CHECK_FALSE(proved_apart(at, lo, hi, 0, from, to));
  }
  at.m[0] = 1;
  CHECK_FALSE(proved_apart(at, lo, hi, HUGE_VAL, from, to));
  const float beyond[3] = {inf, 1, 1};
  CHECK_FALSE(proved_apart(at, lo, beyond, 0, from, to));
}
