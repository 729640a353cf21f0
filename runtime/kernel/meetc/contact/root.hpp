// A coordinate of a point where a segment's line meets a ball's surface, (P + Q sqrt D) / S in integers, and its correct
// rounding.
//
// With d = q - p, w = c - p, B = w . d, C = d . d and D = B^2 - C (w . w - r^2) the line p + t d meets the surface at
// t = (B -+ sqrt D) / C. So S = C, P = p_k C + d_k B, and Q = -d_k for the point at which the line comes in, d_k where it
// goes out, 0 where D is 0. On the grid of the pair a coordinate and the radius are below 2^b; then |B|, C < 2^(2b+4),
// |D| < 2^(4b+9) and |P| < 2^(3b+6). The sign of 2x - y, for a sum y of two numbers in steps of 2^-s of the grid, is that of
// X + Y sqrt D with X = 2^(s+1) P - 2^s S y, below 2^(3b+8+s), and Y = 2^(s+1) Q. Where X and Y have opposite signs, X^2 is
// compared with Y^2 D, in 6b + 18 + 2s bits. Halfway between two numbers this decides a tie. Nothing is divided.
#ifndef MEETC_CONTACT_ROOT_HPP
#define MEETC_CONTACT_ROOT_HPP

#include <meetc/contact/fraction.hpp>

MEETC_NAMESPACE(meetc) {

// m 2^e = |v|, m < 2^53. v finite.
struct decoded_double {
  std::uint64_t m;
  int e;
  bool negative;
};
MEETC_HD inline decoded_double decode_double(double v) {
  std::uint64_t b;
  std::memcpy(&b, &v, sizeof b);
  const std::uint64_t exponent = b >> 52 & 0x7ff, fraction = b & ((std::uint64_t{1} << 52) - 1);
  return {exponent ? fraction | std::uint64_t{1} << 52 : fraction, static_cast<int>(exponent ? exponent : 1) - 1075,
          b >> 63 != 0};
}

// The finite numbers of a type by their places: neighbours have consecutive ones, and 0 and -0 have 0.
template <class Real> struct number_places;
template <> struct number_places<float> {
  using place = std::int32_t;
  static constexpr place magnitude = 0x7fffffff;
};
template <> struct number_places<double> {
  using place = std::int64_t;
  static constexpr place magnitude = 0x7fffffffffffffff;
};
template <class Real> using place_of_number = typename number_places<Real>::place;
template <class Real> MEETC_HD inline place_of_number<Real> to_place(Real v) {
  place_of_number<Real> bits;
  std::memcpy(&bits, &v, sizeof bits);
  return bits < 0 ? -(bits & number_places<Real>::magnitude) : bits;
}
template <class Real> MEETC_HD inline Real at_place(place_of_number<Real> n) {
  const place_of_number<Real> bits = n < 0 ? -n : n;
  Real v;
  std::memcpy(&v, &bits, sizeof v);
  return n < 0 ? -v : v;
}

// Roots of a ball and of a segment whose ends differ, for rounding to Real.
template <class Real> class root_integers {
  // 2^least is the least number of the type. b <= 277 where the grid begins at 2^-149, and less elsewhere.
  static constexpr int least = std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits;

public:
  static constexpr int most = (6 * 277 + 18 + 2 * (-149 - least)) / 64 + 1;

  // For the signs of B and D, and for parts.
  MEETC_HD root_integers(const float *ball, const float *segment)
      : root_integers(ball, segment, join(meetc::grid_of(ball, 4), meetc::grid_of(segment, 6))) {}

  MEETC_HD int sign_of_b() { return x_.sign_of(b); }
  MEETC_HD int sign_of_d() { return x_.sign_of(d); }

  // The coordinate times 2^-exponent() is (P + Q sqrt D) / S.
  MEETC_HD int exponent() const { return common_.low; }
  struct integer {
    std::uint64_t limbs[most];
    int n;
    bool negative;
  };
  struct parts {
    integer p, q, d, s;
  };
  MEETC_HD parts root(int which, int k) {
    set_root(which, k);
    return {magnitude(x_p), magnitude(x_q), magnitude(d), magnitude(c)};
  }

  // The root's coordinate k, and with it the nearest number of the type, lies in [from, to]. Returns that number, of two the
  // even one, and for zero +0.
  MEETC_HD static Real nearest(const float *ball, const float *segment, int which, int k, Real from, Real to) {
    const grid g = join(meetc::grid_of(ball, 4), meetc::grid_of(segment, 6));
    place_of_number<Real> low = to_place(from), high = to_place(to);
    if (low <= 0 && high >= 0) {
      root_integers at_zero(ball, segment, g, g.low);
      at_zero.set_root(which, k);
      const int s = at_zero.side_of(0, 0);
      if (s == 0)
        return 0;
      (s < 0 ? high : low) = 0;
    }
    root_integers x(ball, segment, g, step_from(at_place<Real>(low > 0 ? low : high < 0 ? -high : 0)));
    x.set_root(which, k);
    while (high - low > 1) {
      const place_of_number<Real> middle = low + (high - low) / 2;
      const int s = x.side_of(at_place<Real>(middle), at_place<Real>(middle));
      if (s == 0)
        return at_place<Real>(middle);
      (s < 0 ? high : low) = middle;
    }
    if (low == high)
      return at_place<Real>(low);
    const int s = x.side_of(at_place<Real>(low), at_place<Real>(high));
    return at_place<Real>(s < 0 || (s == 0 && (low & 1) == 0) ? low : high);
  }

private:
  // Registers: points and vectors, the parts, and values.
  static constexpr int at_p = 0, at_d = 3, at_w = 6, b = 9, c = 10, d = 11, x_p = 12, x_q = 13, m = 14, v = 15, u = 16,
                       registers = 17;
  grid common_;
  int finer_ = 0; // s
  wide_integers<registers, most> x_;

  MEETC_HD root_integers(const float *ball, const float *segment, const grid &g)
      : common_(g), x_((4 * g.bits() + 10) / 64 + 1) {
    set_line(ball, segment);
  }
  MEETC_HD root_integers(const float *ball, const float *segment, const grid &g, int step)
      : common_(g), finer_(step < g.low ? g.low - step : 0), x_((6 * g.bits() + 18 + 2 * finer_) / 64 + 1) {
    set_line(ball, segment);
  }
  // The exponent of the step at the least of some magnitudes.
  MEETC_HD static int step_from(Real smallest) {
    const int step = decode_double(double{smallest}).e + 53 - std::numeric_limits<Real>::digits;
    return step > least ? step : least;
  }

  MEETC_HD void set_line(const float *ball, const float *segment) {
    for (int k = 0; k < 3; ++k) {
      x_.set(at_p + k, segment[k], common_.low);
      x_.set(at_d + k, segment[3 + k], common_.low), x_.subtract(at_d + k, at_d + k, at_p + k);
      x_.set(at_w + k, ball[k], common_.low), x_.subtract(at_w + k, at_w + k, at_p + k);
    }
    dot(b, at_w, at_d);
    dot(c, at_d, at_d);
    dot(v, at_w, at_w); // D = B^2 - C (w . w - r^2)
    x_.set(u, ball[3], common_.low);
    x_.multiply(m, u, u);
    x_.subtract(v, v, m);
    x_.multiply(m, c, v);
    x_.multiply(d, b, b);
    x_.subtract(d, d, m);
  }
  MEETC_HD void dot(int r, int first, int second) {
    x_.set(r, std::uint64_t{0});
    for (int k = 0; k < 3; ++k) {
      x_.multiply(m, first + k, second + k);
      x_.add(r, r, m);
    }
  }
  MEETC_HD void set_root(int which, int k) {
    x_.multiply(x_p, at_p + k, c);
    x_.multiply(m, at_d + k, b);
    x_.add(x_p, x_p, m);
    x_.set(x_q, std::uint64_t{0});
    if (which == first_root)
      x_.subtract(x_q, x_q, at_d + k);
    else if (which == second_root)
      x_.add(x_q, x_q, at_d + k);
  }
  MEETC_HD integer magnitude(int r) {
    x_.set(v, std::uint64_t{0});
    x_.add(v, v, r);
    integer out{{}, x_.limbs(), x_.sign_of(r) < 0};
    if (out.negative)
      x_.negate(v);
    for (int i = 0; i < out.n; ++i)
      out.limbs[i] = x_.limb(v, i);
    return out;
  }

  MEETC_HD void load(int r, double number) {
    const decoded_double x = decode_double(number);
    const int shift = x.e - (common_.low - finer_);
    x_.set(r, x.m == 0 || shift >= 0 ? x.m : x.m >> -shift);
    if (shift > 0)
      x_.raise(r, shift);
    if (x.negative)
      x_.negate(r);
  }
  // The sign of 2x - (y + z), for multiples y and z of the step.
  MEETC_HD int side_of(Real y, Real z) {
    load(u, double{y});
    load(v, double{z});
    x_.add(u, u, v);
    x_.multiply(m, c, u);
    x_.set(u, std::uint64_t{0});
    x_.add(u, u, x_p);
    x_.raise(u, finer_ + 1);
    x_.subtract(u, u, m); // X
    x_.set(v, std::uint64_t{0});
    x_.add(v, v, x_q);
    x_.raise(v, finer_ + 1); // Y
    const int by_x = x_.sign_of(u), by_y = x_.sign_of(v) * x_.sign_of(d);
    if (by_x == by_y || by_y == 0)
      return by_x;
    if (by_x == 0)
      return by_y;
    x_.multiply(m, v, v);
    x_.multiply(v, m, d);
    x_.multiply(m, u, u);
    x_.subtract(m, m, v);
    return by_x * x_.sign_of(m);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
