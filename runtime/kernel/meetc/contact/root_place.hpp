// The coordinates of a label of a ball and a segment, each rounded once to float32 or float64 as those of place.hpp: an
// enclosure, cut to the range of the segment, and integers where its ends round to different numbers.
#ifndef MEETC_CONTACT_ROOT_PLACE_HPP
#define MEETC_CONTACT_ROOT_PLACE_HPP

#include <meetc/contact/ball_line.hpp>

MEETC_NAMESPACE(meetc) {

// Cuts the range of a coordinate to that of p + t (q - p) for the root t.
template <class Real>
MEETC_HD void cut_to_root(const typename ball_line<Real>::parameter &root, float p, float q, Real &from, Real &to) {
  using arithmetic = place_arithmetic<Real>;
  const auto length = arithmetic::difference(q, p);
  const auto x = length * root.at + double{p};
  const double size = magnitude_of(leading(length));
  const double error = size * (1.001 * root.error + 16 * arithmetic::u) + 16 * arithmetic::u * magnitude_of(double{p});
  const Real low = arithmetic::end(x, -error), high = arithmetic::end(x, error);
  from = low > from ? low : from, to = high < to ? high : to;
}

// Rows are a centre and a radius, and two ends.
template <class Real>
MEETC_HD void place_round_label(const float *ball, const float *segment, unsigned label, Real *out) {
  if (label_b(label) < 2) {
    for (int k = 0; k < 3; ++k)
      out[k] = static_cast<Real>(segment[3 * label_b(label) + k] + 0.0F);
    return;
  }
  const int which = label_a(label);
  const auto root = ball_line<Real>(ball, segment).root(which);
  for (int k = 0; k < 3; ++k) {
    const float p = segment[k], q = segment[3 + k];
    Real from = static_cast<Real>(p < q ? p : q), to = static_cast<Real>(p < q ? q : p);
    if (standard_environment())
      cut_to_root(root, p, q, from, to);
    out[k] = from < to ? root_integers<Real>::nearest(ball, segment, which, k, from, to) : from + Real(0);
  }
}

} // MEETC_NAMESPACE(meetc)

#endif
