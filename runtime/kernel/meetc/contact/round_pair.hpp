// The contact code of a ball and a segment, and that of other pairs with a ball, which have a witness. They are never wrong,
// and the same on each device, since they are functions of exact signs.
#ifndef MEETC_CONTACT_ROUND_PAIR_HPP
#define MEETC_CONTACT_ROUND_PAIR_HPP

#include <meetc/contact/ball_line.hpp>
#include <meetc/contact/hulls.hpp>
#include <meetc/table/table.hpp>

MEETC_NAMESPACE(meetc) {

// `Side` is the emitted sign of (ball, point); rows are a centre and a radius, and two ends.
template <class Side, bool Surface> class ball_segment_contact {
  static_assert(Side::inputs_a == 4 && Side::inputs_b == 3 && Side::atoms == 1);

public:
  MEETC_HD ball_segment_contact(const float *ball, const float *segment)
      : ball_(ball), segment_(segment), at_p_(side(segment)), at_q_(side(segment + 3)) {}

  MEETC_HD contact_code code() {
    const bool one_point = equal_points(segment_, segment_ + 3);
    if (at_p_ >= 0)
      add(at_p_ > 0 ? in_ball : on_ball, 0);
    if (one_point)
      return found();
    if (at_p_ < 0 && at_q_ < 0)
      by_line();
    else if (at_p_ < 0 && !leaves_outwards(at_q_, false))
      add(first_root, first_edge);
    else if (at_q_ < 0 && !leaves_outwards(at_p_, true))
      add(second_root, first_edge);
    if (at_q_ >= 0)
      add(at_q_ > 0 ? in_ball : on_ball, 1);
    return found();
  }

private:
  const float *ball_, *segment_;
  int at_p_, at_q_; // 1: the end is inside, 0: on the surface
  unsigned labels_[2] = {0, 0};
  int count_ = 0;

  // The sign of the factor, by the centre of a ball.
  MEETC_HD static constexpr int convention() {
    const std::int64_t ball[4] = {0, 0, 0, 1}, point[3] = {0, 0, 0};
    return sign_of_integers<Side>(ball, point);
  }
  static constexpr int factor = convention();
  static_assert(factor != 0, "the sign that tells contacts is not that of a ball and a point");
  MEETC_HD int side(const float *point) const { return factor * exact_sign<Side>(ball_, point); }

  MEETC_HD void add(int carrier_a, int carrier_b) {
    if (!Surface || carrier_a != in_ball)
      labels_[count_++] = label_of(carrier_a, carrier_b);
  }
  MEETC_HD contact_code found() const {
    return Surface ? contact_code::of_points(labels_, count_) : contact_code(labels_, count_);
  }

  // Whether the segment has no other point of the ball than this end, the other end being outside.
  MEETC_HD bool leaves_outwards(int at_end, bool from_p) const {
    return at_end == 0 && (from_p ? ball_line_signs(ball_, segment_).of_b() : beyond_q()) <= 0;
  }
  // The sign of (c - q) . (p - q).
  MEETC_HD int beyond_q() const {
    float back[6];
    for (int k = 0; k < 3; ++k)
      back[k] = segment_[3 + k], back[3 + k] = segment_[k];
    return ball_line_signs(ball_, back).of_b();
  }
  // Both ends are outside.
  MEETC_HD void by_line() {
    const ball_line_signs line(ball_, segment_);
    if (line.of_b() <= 0 || beyond_q() <= 0)
      return;
    const int d = line.of_d();
    if (d == 0)
      add(double_root, first_edge);
    if (d > 0)
      add(first_root, first_edge), add(second_root, first_edge);
  }
};

// predicate_info::contacts of a ball, or of its surface, and a segment.
template <class Side, bool Surface>
void ball_segment_codes(const float *a, const float *b, const index_pair *pairs, std::size_t n, std::uint64_t *codes) {
  for (std::size_t i = 0; i < n; ++i)
    codes[i] = ball_segment_contact<Side, Surface>(a + std::size_t{4} * pairs[i].a, b + std::size_t{6} * pairs[i].b)
                   .code()
                   .bits();
}

// A pair has a witness where it touches, by the exact answer of the predicate.
template <class Touches, bool Surfaces> MEETC_HD contact_code witness_code(const float *a, const float *b) {
#if !defined(__CUDA_ARCH__)
  const bool touches = Touches::after_fp32(a, b);
#else
  const bool touches = later_rungs<Touches>(a, b);
#endif
  return touches ? contact_code::of_witness(Surfaces) : contact_code();
}
// predicate_info::contacts of such pairs.
template <class Touches, bool Surfaces>
void witness_codes(const float *a, const float *b, const index_pair *pairs, std::size_t n, std::uint64_t *codes) {
  for (std::size_t i = 0; i < n; ++i)
    codes[i] = witness_code<Touches, Surfaces>(a + std::size_t{Touches::inputs_a} * pairs[i].a,
                                               b + std::size_t{Touches::inputs_b} * pairs[i].b)
                   .bits();
}

} // MEETC_NAMESPACE(meetc)

#endif
