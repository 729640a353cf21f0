// The frame and the places in it, which decide before any product which pairs are kept.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/runtime/kernel/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace meetc::matrix_test;
using meetc::placing;
using meetc::generated_test::effort;

namespace {

meetc::extent extent_of(const std::vector<sphere> &set) {
  meetc::extent e;
  for (int k = 0; k < 3; ++k)
    clear(e, k);
  for (const sphere &s : set) { // each a warp of its own
    meetc::interval around[3];
    meetc::widen<cga::sphere_shape>(around, s.data());
    for (std::size_t k = 0; k < 3; ++k)
      if (around[k].lo <= around[k].hi) {
        e.low[k] = std::min(e.low[k], meetc::ordered(around[k].lo));
        e.high[k] = std::max(e.high[k], meetc::ordered(around[k].hi));
      }
  }
  return e;
}
bool same(const meetc::matrix_frame &x, const meetc::matrix_frame &y) {
  return x.scale == y.scale && std::equal(x.origin, x.origin + 3, y.origin);
}

constexpr float most = std::numeric_limits<float>::max();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("the frame's own elements lie inside, with every number within reach, or are everywhere") {
  long overflowing = 0;
  for (const family &f : families()) {
    std::mt19937_64 random(3);
    long outside = 0, far_out = 0, wasteful = 0, elements = 0, wrong_frame = 0;
    for (int i = 0; i < effort(20000); ++i) {
      const std::vector<sphere> own = f.make(random).owners;
      const meetc::matrix_frame frame = frame_around(own);
      wrong_frame += !same(frame, meetc::frame_of(extent_of(own))); // joined in whatever way
      double reach = 0;
      for (const sphere &s : own)
        for (const meetc::cover c : {meetc::cover::element, meetc::cover::box}) {
          ball b;
          const placing where = place(frame, s, c, b);
          if (!has_finite_box(s)) {
            ++overflowing;
            outside += where != placing::everywhere;
            continue;
          }
          ++elements;
          outside += where != placing::inside;
          for (std::size_t k = 0; k < 4; ++k)
            far_out += !(std::fabs(b[k]) <= meetc::matrix_reach);
          for (std::size_t k = 0; k < 3; ++k)
            reach = std::max(reach, std::fabs(b[k]) + b[3]);
        }
      wasteful += reach > 0 && reach < meetc::matrix_reach / 2 * (1 - 1e-9) && frame.scale != 1;
    }
    INFO(f.name << ": of " << elements);
    CHECK(outside == 0);
    CHECK(far_out == 0);
    CHECK(wasteful == 0); // the scale is the largest that will do
    CHECK(wrong_frame == 0);
    CHECK(elements > effort(1000));
  }
  CHECK(overflowing > effort(1000));
}

TEST_CASE("an extent's bits are in the order of its numbers, and lead back to them") {
  constexpr double inf = HUGE_VAL;
  const double sorted[] = {
      -inf,    -0x1.fffffffffffffp1023, -0x1p130, -1, -0x1p-149, -0x1p-1074, -0.0, 0.0, 0x1p-1074, 0x1p-149, 1,
      0x1p130, 0x1.fffffffffffffp1023,  inf};
  for (std::size_t i = 0; i < std::size(sorted); ++i) {
    const double back = meetc::from_ordered(meetc::ordered(sorted[i]));
    CHECK(back == sorted[i]);
    CHECK(std::signbit(back) == std::signbit(sorted[i]));
    if (i > 0)
      CHECK(meetc::ordered(sorted[i - 1]) < meetc::ordered(sorted[i]));
  }
  const meetc::extent nothing = extent_of({}); // an empty interval
  CHECK(meetc::from_ordered(nothing.low[0]) == inf);
  CHECK(meetc::from_ordered(nothing.high[0]) == -inf);
}

TEST_CASE("an element whose box overflows is left out of the frame, and is everywhere in it") {
  const sphere small{1, 2, 3, 0.5F}, other{-4, 0, 2, 0.25F};
  const sphere wide{0, 0, 0, most}, right{most, 0, 0, 0}, corner{-most, -most, most, most},
      far{0x1p127F, 0, 0, 0x1p127F};
  const meetc::matrix_frame frame = frame_around({small, other});
  for (const sphere &s : {wide, right, corner, far}) {
    CAPTURE(s[0], s[3]);
    REQUIRE_FALSE(has_finite_box(s));
    CHECK(same(frame_around({small, s, other}), frame));
    CHECK(same(meetc::frame_of(extent_of({s, small, other})), frame));
    // Alone it has a frame as well, and is `everywhere` in it.
    const meetc::matrix_frame alone = meetc::frame_of(extent_of({s}));
    CHECK((std::isfinite(alone.origin[0]) && std::isfinite(alone.origin[1]) && std::isfinite(alone.origin[2])));
    CHECK((alone.scale > 0 && std::isfinite(alone.scale)));
    for (const meetc::matrix_frame &f : {frame, alone})
      for (const meetc::cover c : {meetc::cover::element, meetc::cover::box}) {
        ball b;
        CHECK(place(f, s, c, b) == placing::everywhere);
        CHECK(place(f, small, c, b) != placing::everywhere);
      }
  }
}

TEST_CASE("no ball that has a number which is not finite is inside or apart") {
  const meetc::interval around[3] = {{-1, 1}, {-1, 1}, {-1, 1}};
  const meetc::matrix_frame frame = meetc::frame_of(around);
  for (const double bad : {not_a_number, HUGE_VAL, -HUGE_VAL})
    for (std::size_t k = 0; k < 4; ++k)
      for (const double rest : {0.0, 1.0, 1e30}) {
        ball b{rest, rest, rest, 1};
        b[k] = bad;
        CHECK(place_ball(frame, b.data()) == placing::everywhere);
      }
  for (const double bad : {not_a_number, HUGE_VAL, -HUGE_VAL})
    for (int k = 0; k < 3; ++k)
      for (const bool low : {true, false}) {
        meetc::interval some[3] = {{5, 6}, {5, 6}, {5, 6}};
        (low ? some[k].lo : some[k].hi) = bad;
        CHECK(same(meetc::frame_of(some), {{0, 0, 0}, 1}));
      }
}

TEST_CASE("a frame of no size, of the least and of the largest") {
  const auto at = [](double x, double half) {
    const meetc::interval around[3] = {{x - half, x + half}, {x, x}, {x, x}};
    return meetc::frame_of(around);
  };
  CHECK(at(5, 0).scale == 1);
  CHECK(at(5, 0).origin[1] == 5);
  CHECK(at(0, 0x1p-149).scale == 0x1p159); // 2^-149 < 2^-148
  CHECK(at(0, 1).scale == 0x1p10);
  CHECK(at(0, 0x1.fffffep127).scale == 0x1p-117);
  CHECK(at(0, 0x1.fffffep129).scale == 0x1p-119); // triangles at the end of float32, with their balls
}

TEST_CASE("boxes that are apart touch nothing in the frame") {
  long all_apart = 0, all_astride = 0, all_everywhere = 0;
  for (const family &f : families()) {
    std::mt19937_64 random(5);
    long wrong = 0, apart = 0, astride = 0;
    for (int i = 0; i < effort(20000); ++i) {
      const scene s = f.make(random);
      const meetc::matrix_frame frame = frame_around(s.owners);
      for (const sphere &x : s.others) {
        ball b;
        const placing where = place(frame, x, meetc::cover::element, b);
        apart += where == placing::apart;
        astride += where == placing::astride;
        all_everywhere += where == placing::everywhere;
        if (where == placing::apart)
          for (const sphere &o : s.owners)
            wrong += has_finite_box(o) && touch(o, x);
      }
    }
    INFO(f.name << ": " << apart << " apart, " << astride << " astride");
    CHECK(wrong == 0);
    all_apart += apart, all_astride += astride;
  }
  CHECK(all_apart > effort(5000));
  CHECK(all_astride > effort(5000));
  CHECK(all_everywhere > effort(1000));
}

TEST_CASE("a ball that only just reaches the frame's cube is not apart, one well beyond is") {
  const meetc::interval around[3] = {{-1, 1}, {-1, 1}, {-1, 1}};
  const meetc::matrix_frame frame = meetc::frame_of(around); // the cube is as wide as [-2, 2]
  const auto at = [&](double x, double r) {
    double b[4] = {0, x, 0, r};
    return place_ball(frame, b);
  };
  for (const double r : {0.0, 0x1p-149, 1.0, 1e3, 1e20, 3e38}) {
    CHECK(at(2 + r, r) != placing::apart);
    CHECK(at(-2 - r, r) != placing::apart);
    CHECK(at(1, r) != placing::apart);
  }
  for (const double r : {0.0, 1.0, 1e3, 1e6})
    CHECK(at(2.1 + r, r) == placing::apart);
  CHECK(at(1e30, 1e29) == placing::apart);
  CHECK(at(1, 3) == placing::astride);
}
