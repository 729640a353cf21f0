// The coordinates of a label, each rounded once to float32 or float64: of the exact coordinate to the nearest number, of two
// to the even one, and 0 as +0.
//
// With h as in fraction.hpp, h(p) and h(q) have opposite signs, so that P = |h(p)| and Q = |h(q)| do not cancel in
// x_k = p_k + (q_k - p_k) P / (P + Q). With |error of P| <= eP and |error of Q| <= eQ, the ratio is off by at most
// (eP + eQ) / (P + Q - eP - eQ). The coordinate lies in the range of the edge, and in that of the other's points, so the
// enclosure is cut to both; this makes flat ones exact. If both its ends round to one number, that is the answer, since
// rounding is monotone. Otherwise integers decide (fraction.hpp). For float64 the same is done in double-double.
// Bounds: at most 8 roundings of relative size u lead to h, with u = 2^-53, or 5 * 2^-106 for each operation of
// double-double; no product of four differences of float32 numbers under- or overflows. The constants have room for the
// roundings of the bounds themselves.
#ifndef MEETC_CONTACT_PLACE_HPP
#define MEETC_CONTACT_PLACE_HPP

#include <meetc/contact/fraction.hpp>
#include <meetc/number/double_double.hpp>

MEETC_NAMESPACE(meetc) {

template <class Real> struct place_arithmetic;
template <> struct place_arithmetic<float> {
  using number = double;
  static constexpr double u = 0x1p-53;
  MEETC_HD static number difference(double x, double y) { return x - y; }
  MEETC_HD static number quotient(number x, number y) { return x / y; }
  // The coordinate rounded once more, less or more by the error.
  MEETC_HD static float end(number x, double error) { return static_cast<float>(x + error); }
};
template <> struct place_arithmetic<double> {
  using number = double_words<MEETC_FUSES>;
  static constexpr double u = 0x1p-103;
  MEETC_HD static number difference(double x, double y) { return two_sum<MEETC_FUSES>(x, -y); }
  MEETC_HD static number quotient(number x, number y) {
    const double first = x.hi / y.hi;
    const number rest = x - y * first;
    return fast_two_sum<MEETC_FUSES>(first, rest.hi / y.hi);
  }
  MEETC_HD static double end(number x, double error) { return x.hi + opaque(x.lo + error); }
};

template <class Real> class label_place {
  using arithmetic = place_arithmetic<Real>;
  using number = typename arithmetic::number;

public:
  MEETC_HD explicit label_place(const label_points &of) : of_(of) {
    if (!of.q || !standard_environment())
      return;
    if (of.others == 3) {
      by_face();
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
      by_axis(axis);
  }

  MEETC_HD void write(Real *out) const {
    for (int k = 0; k < 3; ++k)
      if (!find(k, out[k]))
        out[k] = label_fraction(of_).template rounded<Real>(k);
  }
  // Coordinate k, if the enclosure tells it. Otherwise it returns false, and integers would.
  MEETC_HD bool find(int k, Real &out) const {
    const float p = of_.p[k];
    if (!of_.q || of_.q[k] == p)
      return is(p, out);
    float low = least(p, of_.q[k]), high = most(p, of_.q[k]), low_2 = of_.other[0][k], high_2 = low_2;
    for (int i = 1; i < of_.others; ++i)
      low_2 = least(low_2, of_.other[i][k]), high_2 = most(high_2, of_.other[i][k]);
    low = most(low, low_2), high = least(high, high_2);
    if (low == high)
      return is(low, out);
    if (!known_)
      return false;
    const number length = arithmetic::difference(of_.q[k], p);
    const number x = arithmetic::quotient(length * part_, whole_) + double{p};
    const double size = magnitude_of(leading(length));
    const double error = size * ratio_error_ + 16 * arithmetic::u * (size + magnitude_of(double{p}));
    const Real from = most(arithmetic::end(x, -error), static_cast<Real>(low)),
               to = least(arithmetic::end(x, error), static_cast<Real>(high));
    return from == to && is(from, out);
  }

private:
  label_points of_;
  bool known_ = false;
  number whole_ = number(0), part_ = number(0); // P + Q and P
  double ratio_error_ = 0;

  struct bounded {
    number value;
    double magnitude;
  };

  template <class T> MEETC_HD static bool is(T x, Real &out) {
    out = x == 0 ? Real(0) : static_cast<Real>(x);
    return true;
  }
  template <class T> MEETC_HD static T least(T x, T y) { return x < y ? x : y; }
  template <class T> MEETC_HD static T most(T x, T y) { return x > y ? x : y; }

  MEETC_HD number between(const float *x, const float *y, int k) const { return arithmetic::difference(x[k], y[k]); }
  MEETC_HD static double size_of(const number &x) { return magnitude_of(leading(x)); }

  MEETC_HD void by_face() {
    number e[3], f[3], w[3];
    double m[3];
    for (int k = 0; k < 3; ++k)
      e[k] = between(of_.other[1], of_.other[0], k), f[k] = between(of_.other[2], of_.other[0], k);
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      w[k] = e[i] * f[j] - e[j] * f[i];
      m[k] = size_of(e[i]) * size_of(f[j]) + size_of(e[j]) * size_of(f[i]);
    }
    take(w, m, 7);
  }
  MEETC_HD void by_axis(int k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    number w[3];
    w[k] = number(0);
    w[j] = between(of_.other[1], of_.other[0], i);
    w[i] = -between(of_.other[1], of_.other[0], j);
    const double m[3] = {size_of(w[0]), size_of(w[1]), size_of(w[2])};
    take(w, m, 7 & ~(1 << k));
  }
  MEETC_HD bounded height(const number *w, const double *m, int axes, const float *x) const {
    bounded h{number(0), 0};
    for (int k = 0; k < 3; ++k)
      if ((axes >> k & 1) != 0) {
        const number d = between(x, of_.other[0], k);
        h.value = h.value + w[k] * d;
        h.magnitude += m[k] * size_of(d);
      }
    return h;
  }
  // Takes h with these components of W, and the magnitudes of their terms, if both heights are surely not 0, and farther
  // apart than those that are taken.
  MEETC_HD void take(const number *w, const double *m, int axes) {
    const bounded at_p = height(w, m, axes, of_.p), at_q = height(w, m, axes, of_.q);
    const double error_p = 16 * arithmetic::u * at_p.magnitude, error_q = 16 * arithmetic::u * at_q.magnitude;
    const double hp = leading(at_p.value), hq = leading(at_q.value);
    if (!(magnitude_of(hp) > error_p && magnitude_of(hq) > error_q) || (hp > 0) == (hq > 0))
      return;
    const number whole = hp > 0 ? at_p.value - at_q.value : at_q.value - at_p.value;
    if (known_ && leading(whole) <= leading(whole_))
      return;
    known_ = true;
    whole_ = whole;
    part_ = hp > 0 ? at_p.value : -at_p.value;
    ratio_error_ = 1.0001 * (error_p + error_q) / (leading(whole) - error_p - error_q) + 16 * arithmetic::u;
  }
};

// The coordinates of a label of a pair, under the standard word.
template <class Real>
MEETC_HD void place_label(const contact_element &a, const contact_element &b, unsigned label, Real *out) {
  label_place<Real>(label_points(a, b, label)).write(out);
}

} // MEETC_NAMESPACE(meetc)

#endif
