// The line of a segment and the surface of a ball: signs, and an enclosure of the coordinates of the roots.
//
// With w, d, B, C and D as in root.hpp, D is also C r^2 - |w x d|^2, whose terms are small where the segment is far from the
// ball. Bounds: at most 5 roundings of relative size u lead to B, to C and to a component of w x d, and 8 to C r^2; no product
// of four differences of float32 numbers under- or overflows. The constants have room for the roundings of the bounds
// themselves, and for the square root, 2u. u is as in place.hpp.
#ifndef MEETC_CONTACT_BALL_LINE_HPP
#define MEETC_CONTACT_BALL_LINE_HPP

#include <meetc/contact/place.hpp>
#include <meetc/contact/root.hpp>
#include <meetc/contact/square_root.hpp>

MEETC_NAMESPACE(meetc) {

// B, C and D with their bounds; Real is as in place.hpp.
template <class Real> class ball_line {
  using arithmetic = place_arithmetic<Real>;
  using number = typename arithmetic::number;

public:
  MEETC_HD ball_line(const float *ball, const float *segment) {
    number d[3], w[3];
    double sizes = 0;
    for (int k = 0; k < 3; ++k) {
      d[k] = arithmetic::difference(segment[3 + k], segment[k]);
      w[k] = arithmetic::difference(ball[k], segment[k]);
      b_ = b_ + w[k] * d[k];
      c_ = c_ + d[k] * d[k];
      sizes += size_of(w[k]) * size_of(d[k]);
    }
    error_b_ = 8 * arithmetic::u * sizes;
    number squares = number(0);
    double spread = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const number x = w[i] * d[j] - w[j] * d[i];
      const double error = 8 * arithmetic::u * (size_of(w[i]) * size_of(d[j]) + size_of(w[j]) * size_of(d[i]));
      squares = squares + x * x;
      spread += (2 * size_of(x) + error) * error;
    }
    const number reach = c_ * (number(double{ball[3]}) * double{ball[3]});
    d_ = reach - squares;
    error_d_ = spread + 16 * arithmetic::u * (leading(reach) + leading(squares));
  }

  // The sign, or 2 where it is not proved.
  MEETC_HD int sign_of_b() const { return proved(leading(b_), error_b_); }
  MEETC_HD int sign_of_d() const { return proved(leading(d_), error_d_); }

  // t of a root, and by how much it may be off.
  struct parameter {
    number at;
    double error;
  };
  MEETC_HD parameter root(int which) const {
    number sum = b_;
    double error = error_b_;
    if (which != double_root) { // where D is not 0
      const double d = leading(d_) > 0 ? leading(d_) : 0;
      const number s = d > 0 ? square_root(d_) : number(0);
      error += (d > error_d_ ? error_d_ / leading(s) : std::sqrt(2 * error_d_)) + 4 * arithmetic::u * leading(s);
      sum = which == first_root ? b_ - s : b_ + s;
    }
    const double c = leading(c_);
    return {arithmetic::quotient(sum, c_), 1.0001 * error / c + 16 * arithmetic::u * size_of(sum) / c};
  }

private:
  number b_ = number(0), c_ = number(0), d_ = number(0);
  double error_b_ = 0, error_d_ = 0;

  MEETC_HD static double size_of(const number &x) { return magnitude_of(leading(x)); }
  MEETC_HD static int proved(double value, double error) { return value > error ? 1 : value < -error ? -1 : 2; }
};

// The exact signs, under the standard word, of a segment whose ends differ.
class ball_line_signs {
public:
  MEETC_HD ball_line_signs(const float *ball, const float *segment)
      : ball_(ball), segment_(segment), near_(ball, segment) {}

  MEETC_HD int of_b() const { // of w . d: whether the part nearest to the centre lies beyond p
    if (const int s = near_.sign_of_b(); s != 2 && standard_environment())
      return s;
    return exact().sign_of_b();
  }
  MEETC_HD int of_d() const {
    if (const int s = near_.sign_of_d(); s != 2 && standard_environment())
      return s;
    return exact().sign_of_d();
  }

private:
  const float *ball_, *segment_;
  ball_line<float> near_;

  MEETC_HD root_integers<float> exact() const { return root_integers<float>(ball_, segment_); }
};

} // MEETC_NAMESPACE(meetc)

#endif
