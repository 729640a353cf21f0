// core/two_balls.hpp: the test of two balls by their boxes alone.
//
// Problem: a search compares the boxes of balls, and half of the pairs whose boxes touch are apart; the balls' own numbers lie
// elsewhere in memory. Method: a ball's box is wider than the ball by a few roundings (meetc::step_down and step_up), so that
// it says where the centre is and how large the radius is, up to an error that is small beside the ends of the box. Two balls
// are compared by these, once with both errors for them and once against them.
//
// It is a filter: what it calls apart is proved apart, and what it calls touching is proved to touch, as closed balls
// (tests/proofs/two_balls_*.gappa). All lengths are doubled, which saves halving the sums. The error is at least 2^-60, so
// that what squares lose by underflow does not matter. Nearly all pairs are decided where lengths are from about 2^-50 to 2^62;
// below, where the error is as large as the balls, and above, where squares overflow, nothing is proved. Where an end is so large that the sum overflows, the error is infinite and nothing is proved;
// such an end may be one that was cut to float32's range.
#ifndef MEETC_CORE_TWO_BALLS_HPP
#define MEETC_CORE_TWO_BALLS_HPP

#include "meetc/support.hpp"

#include <cmath>

namespace meetc {

// How large the error of a ball's two numbers is: so much of the sum of the box's ends, and at least the term.
struct ball_margin {
  float factor = 0x1p-19f, term = 0x1p-60f;
};

// Of a ball twice the centre, and twice the radius with the error of both added and taken away.
struct boxed_ball {
  float centre[3], most, least;
};

// The ends are finite, and low is not above high.
MEETC_HD inline boxed_ball ball_in_box(const float (&low)[3], const float (&high)[3], ball_margin margin = {}) {
  boxed_ball b{};
  float side = 0;
  for (int k = 0; k < 3; ++k) {
    b.centre[k] = low[k] + high[k];
    side = high[k] - low[k] > side ? high[k] - low[k] : side;
  }
  const float ends = fabsf(b.centre[0]) + fabsf(b.centre[1]) + fabsf(b.centre[2]) + side;
  const float error = ends * margin.factor + margin.term;
  b.most = side + error, b.least = side - error;
  return b;
}

struct ball_verdict {
  bool apart, touch; // proved; at most one of them
};

// Where a number has overflowed, both sides of a comparison are infinite, or one is NaN, and nothing is proved; or the comparison
// holds of the true numbers too.
MEETC_HD inline ball_verdict compare(const boxed_ball &a, const boxed_ball &b) {
  const float x = a.centre[0] - b.centre[0], y = a.centre[1] - b.centre[1], z = a.centre[2] - b.centre[2];
  const float square = fma(z, z, fma(y, y, x * x)), most = a.most + b.most, least = a.least + b.least;
  return {square > most * most, square < least * fabsf(least)};
}

} // namespace meetc

#endif
