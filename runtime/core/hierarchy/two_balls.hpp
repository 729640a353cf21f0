// core/hierarchy/two_balls.hpp: the test of two balls by their boxes alone.
//
// Problem: a search compares the boxes of balls, and half of the pairs whose boxes touch are apart; the balls' own
// numbers lie elsewhere in memory. Method: a ball's box is wider than the ball by a few roundings (meetc::step_down and
// step_up), so it gives the centre and the radius up to an error that is small beside the ends of the box. Two balls
// are compared by these, once with both errors for them and once against them.
//
// It is a filter: balls that it calls apart are proved apart, and balls that it calls touching are proved to touch, as
// closed balls. All lengths are doubled, which saves halving the sums. The box of a ball with the centre c and the
// radius r has the ends l_k and h_k. Twice the centre, twice the radius and their error are taken to be
//   C_k = fl(l_k + h_k),   s = max_k fl(h_k - l_k),   e = fl(fl(2^-19 m) + 2^-60),
// where m is the computed sum of the |C_k| and s. With P = fl(s + e) and L = fl(s - e) of each ball, P' and L' the
// computed sums of both balls' P and L, and q the computed square of the distance of both C, the pair is apart if q >
// fl(P'^2) and touches if q < fl(L' |L'|). Nearly all pairs are decided if lengths are from about 2^-50 to 2^62; below,
// the error is as large as the balls, and above, squares overflow, so that nothing is proved.
//
// Proof. Let M be the greatest magnitude of an end. The ends enclose the ball, and each is within one rounding and two
// steps of it (tests/generated), so that l_k + h_k is within 5 2^-24 M + 2^-148 of 2 c_k, and C is within W = sqrt(3)
// (8 2^-24 M + 2^-148) of 2c. The side s is, before its rounding, at least 2r and at most 11 2^-24 M + 2^-147 more; and
// m is at least 2M, up to five roundings, since |l_k + h_k| + |h_k - l_k| is twice the larger magnitude of the two.
// From this Gappa proves P >= (2r + W)(1 + 2^-21) and L (1 + 2^-21) + 2^-62 <= 2r - W (two_balls_most.gappa and
// two_balls_least.gappa in tests/proofs). Let D be the exact distance of both C. If the balls touch, then D is at most
// the sum of both 2r + W, so that D (1 + 2^-21) is at most the sum of both P, and Gappa proves q <= fl(P'^2)
// (two_balls_apart.gappa). If they are apart, then D exceeds the sum of both 2r - W, hence that of both L times 1 +
// 2^-21 by 2^-61, and Gappa proves q >= fl(L'^2) if the sum of both L is not negative (two_balls_touch.gappa); if it
// is, L' |L'| is not positive, and q is not less. Coq checks the four proofs.
//
// Overflow. Let one end of an axis be cut to float32's range, so that its magnitude is the largest, F, and let h be the
// other end. If |h| < 2^103, then |C_k| and the side both round to F at least, and m overflows with their sum. Else the
// side or C_k is at least F + 2^103 before its rounding, and overflows itself. So P is infinite, L is negative and
// infinite, or NaN, and nothing is proved, as when C is infinite for another reason. Else a sum or a square overflows
// only if it is beyond float32. An infinite q is above no infinite square, and below none; it exceeds a finite one as
// the true numbers do. An infinite P' separates nothing, and an infinite L' or square of it proves a contact only if q
// is finite, hence less than it. Contraction only removes roundings.
#ifndef MEETC_CORE_HIERARCHY_TWO_BALLS_HPP
#define MEETC_CORE_HIERARCHY_TWO_BALLS_HPP

#include "meetc/support.hpp"

#include <cmath>

namespace meetc {

// The error of a ball's two numbers: a share of the sum of the box's ends, and the term.
struct ball_margin {
  float factor = 0x1p-19f, term = 0x1p-60f;
};

// A ball by its box: twice the centre, and twice the radius with the error of both added and taken away.
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

// If a number has overflowed, both sides of a comparison are infinite, or one is NaN, and nothing is proved; or the
// comparison holds of the true numbers too.
MEETC_HD inline ball_verdict compare(const boxed_ball &a, const boxed_ball &b) {
  const float x = a.centre[0] - b.centre[0], y = a.centre[1] - b.centre[1], z = a.centre[2] - b.centre[2];
  const float square = fma(z, z, fma(y, y, x * x)), most = a.most + b.most, least = a.least + b.least;
  return {square > most * most, square < least * fabsf(least)};
}

} // namespace meetc

#endif
