// The frame and the places in it: what decides, before any product, which pairs are kept and which are not.
#include "tests/generated/catch.hpp"
#include "tests/generated/effort.hpp"
#include "tests/matrix/scenes.hpp"

#include <cmath>

using namespace meetc::matrix_test;
using meet::placing;
using meetc::generated_test::effort;

namespace {

std::vector<ball> enclosing_all(const std::vector<sphere> &s) {
  std::vector<ball> out;
  for (const sphere &x : s)
    out.push_back(enclosing(x));
  return out;
}

// In all axes the radius is lost beside the centre, in fp64: the frame is then narrower than the ball.
bool vanishing(const ball &b) {
  bool small = b[3] > 0;
  for (std::size_t k = 0; k < 3; ++k)
    small = small && b[3] <= std::fabs(b[k]) * 0x1p-51;
  return small;
}

} // namespace

TEST_CASE("the frame's own balls lie inside, with every number within reach") {
  for (const family &f : families()) {
    std::mt19937_64 random(3);
    long outside = 0, far_out = 0, wasteful = 0, balls = 0, lost = 0;
    for (int i = 0; i < effort(20000); ++i) {
      const std::vector<ball> own = enclosing_all(f.make(random).owners);
      const meet::matrix_frame frame = frame_around(own);
      double reach = 0;
      for (ball b : own) {
        if (vanishing(b)) {
          ++lost;
          reach = HUGE_VAL;
          continue;
        }
        outside += place_ball(frame, b.data()) != placing::inside;
        for (std::size_t k = 0; k < 4; ++k)
          far_out += !(std::fabs(b[k]) <= meet::matrix_reach);
        for (std::size_t k = 0; k < 3; ++k)
          reach = std::max(reach, std::fabs(b[k]) + b[3]);
        ++balls;
      }
      wasteful += reach > 0 && reach < meet::matrix_reach / 2 * (1 - 1e-9) && frame.scale != 1;
    }
    INFO(f.name << ": of " << balls << " balls, and " << lost << " whose radius vanishes");
    CHECK(outside == 0);
    CHECK(far_out == 0);
    CHECK(wasteful <= balls / 500); // the scale is the largest that will do, but for radii that nearly vanish
    CHECK(balls > lost);
  }
}

TEST_CASE("a frame of no size, of the least and of the largest") {
  const auto at = [](double x, double half) {
    const meet::interval around[3] = {{x - half, x + half}, {x, x}, {x, x}};
    return meet::frame_of(around);
  };
  CHECK(at(5, 0).scale == 1);
  CHECK(at(5, 0).origin[1] == 5);
  CHECK(at(0, 0x1p-149).scale == 0x1p159); // 2^-149 < 2^-148
  CHECK(at(0, 1).scale == 0x1p10);
  CHECK(at(0, 0x1.fffffep127).scale == 0x1p-117);
  CHECK(at(0, 0x1.fffffep129).scale == 0x1p-119); // triangles at the end of float32, with their balls
}

TEST_CASE("what is apart touches nothing in the frame") {
  long all_apart = 0, all_astride = 0;
  for (const family &f : families()) {
    std::mt19937_64 random(5);
    long wrong = 0, apart = 0, astride = 0;
    for (int i = 0; i < effort(20000); ++i) {
      const scene s = f.make(random);
      const std::vector<ball> own = enclosing_all(s.owners);
      const meet::matrix_frame frame = frame_around(own);
      for (const sphere &x : s.others) {
        const ball b = enclosing(x);
        ball placed = b;
        const placing where = place_ball(frame, placed.data());
        apart += where == placing::apart;
        astride += where == placing::astride;
        if (where == placing::apart)
          for (const ball &o : own)
            wrong += touch(o, b);
      }
    }
    INFO(f.name << ": " << apart << " apart, " << astride << " astride");
    CHECK(wrong == 0);
    all_apart += apart, all_astride += astride;
  }
  CHECK(all_apart > effort(5000));
  CHECK(all_astride > effort(5000));
}

TEST_CASE("a ball that only just reaches the frame's cube is not apart, one well beyond is") {
  const meet::interval around[3] = {{-1, 1}, {-1, 1}, {-1, 1}};
  const meet::matrix_frame frame = meet::frame_of(around); // the cube is as wide as [-2, 2]
  const auto place = [&](double x, double r) {
    double b[4] = {0, x, 0, r};
    return place_ball(frame, b);
  };
  for (const double r : {0.0, 0x1p-149, 1.0, 1e3, 1e20, 3e38}) {
    CHECK(place(2 + r, r) != placing::apart);
    CHECK(place(-2 - r, r) != placing::apart);
    CHECK(place(1, r) != placing::apart);
  }
  for (const double r : {0.0, 1.0, 1e3, 1e6})
    CHECK(place(2.1 + r, r) == placing::apart);
  CHECK(place(1e30, 1e29) == placing::apart);
  CHECK(place(1, 3) == placing::astride);
}
