// The test of two balls by their boxes: its claims are true, from 2^-149 to 2^127, and it makes one for most pairs.
#include "meet/core/hierarchy/two_balls.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cfloat>
#include <fstream>
#include <gmpxx.h>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

using namespace meetc;

namespace {

struct ball {
  float x[4]; // centre and radius
};
using scene = std::pair<ball, ball>;

float uniform(std::mt19937 &g, float least, float most) {
  return std::uniform_real_distribution<float>(least, most)(g);
}
float power(std::mt19937 &g, int least, int most) {
  return std::ldexp(1.0F, least + static_cast<int>(g() % static_cast<unsigned>(most - least + 1)));
}

// As the shapes of a catalogue make boxes, or one step wider at some ends, and finite as those of a tree.
void box_of(const ball &b, std::mt19937 &g, float (&low)[3], float (&high)[3]) {
  for (int k = 0; k < 3; ++k) {
    low[k] = step_down(b.x[k] - b.x[3]), high[k] = step_up(b.x[k] + b.x[3]);
    if (g() % 4 == 0)
      low[k] = step_down(low[k]);
    if (g() % 4 == 0)
      high[k] = step_up(high[k]);
    low[k] = std::clamp(low[k], -FLT_MAX, FLT_MAX), high[k] = std::clamp(high[k], -FLT_MAX, FLT_MAX);
  }
}

bool touch(const scene &s) {
  mpq_class square = 0;
  for (int k = 0; k < 3; ++k) {
    const mpq_class way = mpq_class(s.first.x[k]) - mpq_class(s.second.x[k]);
    square += way * way;
  }
  const mpq_class reach = mpq_class(s.first.x[3]) + mpq_class(s.second.x[3]);
  return square <= reach * reach;
}

// Nearly tangent, at a distance of about the radii, which are small beside the centres or not.
scene nearly_tangent(std::mt19937 &g, float unit) {
  scene s;
  const float small = power(g, -22, 0);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    s.first.x[k] = unit * uniform(g, -1, 1);
    s.second.x[k] = s.first.x[k] + unit * small * uniform(g, -1, 1);
    const double way = static_cast<double>(s.first.x[k]) - static_cast<double>(s.second.x[k]);
    square += way * way;
  }
  const double reach = std::sqrt(square) * (1 + static_cast<double>(uniform(g, -1, 1) * power(g, -26, -2)));
  s.first.x[3] = static_cast<float>(reach * static_cast<double>(uniform(g, 0, 1)));
  s.second.x[3] = std::max(0.0F, static_cast<float>(reach - static_cast<double>(s.first.x[3])));
  return s;
}
scene anywhere(std::mt19937 &g) {
  return nearly_tangent(g, power(g, -149, 126));
}
// Squares of these lengths are subnormal.
scene near_underflow(std::mt19937 &g) {
  return nearly_tangent(g, power(g, -76, -70));
}
// Every magnitude at once.
scene extreme(std::mt19937 &g) {
  const auto number = [&] {
    const float some[] = {0,        0x1p-149F, 0x1.8p-148F,        FLT_MIN, 1, 1.5F, 0x1p64F, 0x1p126F,
                          0x1p127F, FLT_MAX,   power(g, -149, 127)};
    return some[g() % std::size(some)] * (g() % 2 ? 1.0F : -1.0F);
  };
  scene s;
  for (ball *const b : {&s.first, &s.second}) {
    for (float &x : b->x)
      x = number();
    b->x[3] = std::abs(b->x[3]);
  }
  return s;
}

struct findings {
  int touching = 0, apart = 0, decided = 0, wrong = 0;
};
template <class Make> findings judge(const Make &make, unsigned seed, int rounds, ball_margin margin = {}) {
  std::mt19937 g(seed);
  findings f;
  for (int i = 0; i < rounds; ++i) {
    const scene s = make(g);
    float low[2][3], high[2][3];
    box_of(s.first, g, low[0], high[0]), box_of(s.second, g, low[1], high[1]);
    const ball_verdict v = compare(ball_in_box(low[0], high[0], margin), ball_in_box(low[1], high[1], margin));
    const bool truth = touch(s);
    ++(truth ? f.touching : f.apart);
    f.decided += v.apart || v.touch;
    f.wrong += (v.apart && truth) || (v.touch && !truth) || (v.apart && v.touch);
  }
  return f;
}

} // namespace

TEST_CASE("two balls: the claims of their boxes are true") {
  for (const auto &make : {anywhere, near_underflow, extreme}) {
    const findings f = judge(make, 90, 60'000);
    CHECK(f.wrong == 0);
    CHECK(f.touching > 3000);
    CHECK(f.apart > 3000);
  }
}

TEST_CASE("two balls: nearly all pairs are decided, at any scale that the error's term and their squares allow") {
  for (const float unit : {0x1p-46F, 0x1p-30F, 1.0F, 0x1p30F, 0x1p62F}) {
    const auto large = [unit](std::mt19937 &g) {
      scene s;
      for (ball *const b : {&s.first, &s.second}) {
        for (float &x : b->x)
          x = unit * uniform(g, -1, 1);
        b->x[3] = std::abs(b->x[3]);
      }
      return s;
    };
    const findings f = judge(large, 91, 20'000);
    CHECK(f.wrong == 0);
    CHECK(f.decided > 19'980);
    CHECK(f.touching > 3000);
    CHECK(f.apart > 3000);
  }
}

TEST_CASE("two balls: a smaller margin makes wrong claims") {
  const ball_margin all;
  CHECK(judge(anywhere, 92, 60'000, {all.factor / 16, all.term}).wrong > 0);
  CHECK(judge(near_underflow, 93, 60'000, {all.factor, 0}).wrong > 0);
}

TEST_CASE("two balls: the margin is the one that is proved") {
  const ball_margin m;
  for (const char *const name : {"two_balls_most", "two_balls_least"}) {
    std::ifstream file(std::string(MEETC_PROOFS) + name + ".gappa");
    std::stringstream text;
    text << file.rdbuf();
    CHECK(text.str().find("\nfactor = 1b-19;\nterm = 1b-60;\n") != std::string::npos);
  }
  CHECK(m.factor == 0x1p-19F);
  CHECK(m.term == 0x1p-60F);
}

TEST_CASE("two balls: an end that was cut to float32's range proves nothing") {
  const float low[3] = {0, 0, 0}, one[3] = {1, 1, 1};
  const boxed_ball other = ball_in_box(low, one);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool both_ends : {false, true}) {
      float from[3] = {0, 0, 0}, to[3] = {1, 1, 1};
      to[axis] = FLT_MAX;
      if (both_ends)
        from[axis] = -FLT_MAX;
      const boxed_ball cut = ball_in_box(from, to);
      for (const boxed_ball &b : {cut, other}) {
        const ball_verdict v = compare(cut, b), w = compare(b, cut);
        CHECK_FALSE((v.apart || v.touch || w.apart || w.touch));
      }
    }
}
