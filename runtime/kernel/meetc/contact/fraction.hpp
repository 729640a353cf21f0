// The coordinates of a label as fractions of integers, and their correct rounding.
//
// With h(x) = W . (x - o), W = (b-a) x (c-a) and o = a for a face, the point of the edge from p to q where h is 0 is
// (q h(p) - p h(q)) / (h(p) - h(q)). Two edges lie in one plane; there h is the turn of the other edge with x, along an axis on
// which the denominator is not 0. On the grid of the points a coordinate is below 2^b, a difference below 2^(b+1), and
// numerator and denominator below 2^(4b+6). They have no upper limit but that of float32, so limbs hold them.
#ifndef MEETC_CONTACT_FRACTION_HPP
#define MEETC_CONTACT_FRACTION_HPP

#include <meetc/contact/label_points.hpp>
#include <meetc/decide/bytecode.hpp>

#include <cmath>
#include <limits>

MEETC_NAMESPACE(meetc) {

// Integers in registers, in two's complement, all of n limbs.
template <int Registers, int Most> class wide_integers {
public:
  MEETC_HD explicit wide_integers(int limbs) : n_(limbs) {}
  MEETC_HD int limbs() const { return n_; }
  MEETC_HD std::uint64_t limb(int r, int i) const { return at_[r][i]; }
  MEETC_HD void set(int r, float v, int low) { to_limbs(v, low, n_, at_[r]); }
  MEETC_HD void set(int r, std::uint64_t m) {
    for (int i = 0; i < n_; ++i)
      at_[r][i] = i == 0 ? m : 0;
  }
  MEETC_HD void add(int r, int a, int b) { run(opcode::add, r, a, b); }
  MEETC_HD void subtract(int r, int a, int b) { run(opcode::subtract, r, a, b); }
  MEETC_HD void multiply(int r, int a, int b) { run(opcode::multiply, r, a, b); } // r is neither a nor b
  MEETC_HD void negate(int r) { run(opcode::negate, r, r, r); }
  MEETC_HD int sign_of(int r) {
    sign s[1];
    execute<Most>({opcode::take_sign, 0, static_cast<std::uint16_t>(r), 0}, n_, at_, s);
    return static_cast<int>(s[0]);
  }
  // The length of a number that is not negative.
  MEETC_HD int bits(int r) const {
    for (int i = n_; i-- > 0;)
      if (at_[r][i] != 0) {
        int bits = 64 * i;
        for (std::uint64_t v = at_[r][i]; v != 0; v >>= 1)
          ++bits;
        return bits;
      }
    return 0;
  }
  MEETC_HD void raise(int r, int by) { // times 2^by
    const int limbs = by / 64, rest = by % 64;
    for (int i = n_; i-- > 0;) {
      const std::uint64_t high = i >= limbs ? at_[r][i - limbs] : 0, low = i > limbs ? at_[r][i - limbs - 1] : 0;
      at_[r][i] = rest == 0 ? high : high << rest | low >> (64 - rest);
    }
  }
  MEETC_HD void halve(int r) {
    for (int i = 0; i < n_; ++i)
      at_[r][i] = at_[r][i] >> 1 | (i + 1 < n_ ? at_[r][i + 1] << 63 : 0);
  }
  MEETC_HD bool less(int a, int b) const {
    for (int i = n_; i-- > 0;)
      if (at_[a][i] != at_[b][i])
        return at_[a][i] < at_[b][i];
    return false;
  }

private:
  int n_;
  std::uint64_t at_[Registers][Most];
  MEETC_HD void run(opcode code, int r, int a, int b) {
    execute<Most>({code, static_cast<std::uint16_t>(r), static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)},
                  n_, at_, nullptr);
  }
};

class label_fraction {
public:
  // Finite float32 numbers have b <= 277. Rounding to float64 takes 57 bits more, and the sign one.
  static constexpr int most = (4 * 277 + 6 + 58) / 64 + 1;

  // The label is no corner.
  MEETC_HD explicit label_fraction(const label_points &of)
      : common_(grid_of(of)), x_((4 * common_.bits() + 6 + 58) / 64 + 1) {
    for (int k = 0; k < 3; ++k) {
      load(p + k, of.p[k]), load(q + k, of.q[k]);
      load(o + k, of.other[0][k]);
      load(e + k, of.other[1][k]), x_.subtract(e + k, e + k, o + k);
      if (of.others == 3)
        load(f + k, of.other[2][k]), x_.subtract(f + k, f + k, o + k);
    }
    if (of.others == 3) {
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        x_.multiply(w + k, e + i, f + j);
        x_.multiply(s, e + j, f + i);
        x_.subtract(w + k, w + k, s);
      }
      heights();
      return;
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      x_.subtract(w + k, e, e); // 0
      x_.add(w + j, w + k, e + i);
      x_.subtract(w + i, w + k, e + j);
      heights();
      if (x_.sign_of(den) != 0)
        return;
    }
  }

  // The coordinate times 2^-exponent() is the fraction of numerator(k) and denominator().
  MEETC_HD int exponent() const { return common_.low; }
  // Their limbs, without a sign; `negative`: that of the whole.
  struct parts {
    std::uint64_t numerator[most], denominator[most];
    int limbs;
    bool negative;
  };
  MEETC_HD parts fraction(int k) {
    parts out;
    out.negative = make_positive(k);
    out.limbs = x_.limbs();
    for (int i = 0; i < out.limbs; ++i)
      out.numerator[i] = x_.limb(num, i), out.denominator[i] = x_.limb(below, i);
    return out;
  }

  // The nearest number of the type; of two the even one. A zero is +0.
  template <class Real> MEETC_HD Real rounded(int k) {
    constexpr int digits = std::numeric_limits<Real>::digits,
                  least = std::numeric_limits<Real>::min_exponent - digits; // 2^least is the least number
    const bool negative = make_positive(k);
    const int length = x_.bits(num);
    if (length == 0)
      return 0;
    // A quotient of digits + 2 or digits + 3 bits.
    const int shift = digits + 2 - (length - x_.bits(below));
    if (shift > 0)
      x_.raise(num, shift);
    else
      x_.raise(below, -shift);
    x_.raise(below, digits + 2);
    std::uint64_t quotient = 0;
    for (int i = 0; i < digits + 3; ++i) {
      quotient <<= 1;
      if (!x_.less(num, below)) {
        x_.subtract(num, num, below);
        quotient |= 1;
      }
      x_.halve(below);
    }
    const bool more = x_.sign_of(num) != 0;
    const int unit = common_.low - shift; // of the quotient
    int bits = 0;
    for (std::uint64_t v = quotient; v != 0; v >>= 1)
      ++bits;
    const int last = unit + bits - digits > least ? unit + bits - digits : least, dropped = last - unit;
    if (dropped > 63)
      return 0;
    std::uint64_t kept = quotient >> dropped;
    const std::uint64_t rest = quotient & ((std::uint64_t{1} << dropped) - 1), half = std::uint64_t{1} << (dropped - 1);
    kept += rest > half || (rest == half && (more || (kept & 1) != 0));
    const auto size = static_cast<Real>(std::ldexp(static_cast<double>(kept), last));
    return negative && size != 0 ? -size : size;
  }

private:
  // Registers: the edge, the other's points from its first one, and values.
  static constexpr int p = 0, q = 3, o = 6, e = 9, f = 12, w = 15, hp = 18, hq = 19, den = 20, num = 21, below = 22,
                       s = 23, t = 24, registers = 25;
  grid common_;
  wide_integers<registers, most> x_;

  MEETC_HD static grid grid_of(const label_points &of) {
    grid g = join(meetc::grid_of(of.p, 3), meetc::grid_of(of.q, 3));
    for (int i = 0; i < of.others; ++i)
      g = join(g, meetc::grid_of(of.other[i], 3));
    return g;
  }
  MEETC_HD void load(int r, float v) { x_.set(r, v, common_.low); }
  MEETC_HD void heights() {
    height(hp, p);
    height(hq, q);
    x_.subtract(den, hp, hq);
  }
  MEETC_HD void height(int r, int point) {
    x_.subtract(r, p, p); // 0
    for (int k = 0; k < 3; ++k) {
      x_.subtract(s, point + k, o + k);
      x_.multiply(t, w + k, s);
      x_.add(r, r, t);
    }
  }
  // Writes the magnitudes of numerator and denominator, and returns whether the fraction is negative.
  MEETC_HD bool make_positive(int k) {
    x_.multiply(num, q + k, hp);
    x_.multiply(s, p + k, hq);
    x_.subtract(num, num, s);
    x_.subtract(s, s, s);
    x_.add(below, den, s);
    const bool up = x_.sign_of(num) < 0, down = x_.sign_of(below) < 0;
    if (up)
      x_.negate(num);
    if (down)
      x_.negate(below);
    return up != down;
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
