// a b + c, rounded once, for the evaluation of constants: gcc 12 evaluates its own function there, and clang 14 does not.
//
// Method: the product and c as integers of 128 bits whose highest bit is bit 125. The smaller one is moved to the exponent
// of the other, and a bit that it loses stays as bit 0. This is below the last bit of a result by at least 50 places, even
// after a cancellation: if d > 1 places are moved, at most one leading bit cancels, and if d <= 20, no bit is lost.
#ifndef MEETC_NUMBER_CONSTANT_FMA_HPP
#define MEETC_NUMBER_CONSTANT_FMA_HPP

#include <meetc/environment/environment.hpp>

MEETC_NAMESPACE(meetc) {
namespace constants {

__extension__ typedef unsigned __int128 wide;

// magnitude * 2^exponent, with its sign.
struct value {
  wide magnitude;
  int exponent;
  bool negative;
};

MEETC_HD constexpr value value_of(double x) {
  const auto bits = __builtin_bit_cast(std::uint64_t, x);
  const auto field = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffff;
  return {field ? fraction | 0x10000000000000 : fraction, field ? field - 1075 : -1074, bits >> 63 != 0};
}
// The same value, whose highest bit is bit 125; for values other than 0.
MEETC_HD constexpr value raised(value x) {
  for (; x.magnitude >> 125 == 0; x.magnitude <<= 1)
    --x.exponent;
  return x;
}
// x moved down by `places`; a bit that is lost stays as bit 0.
MEETC_HD constexpr wide lowered(wide x, int places) {
  if (places <= 0)
    return x;
  return places > 127 ? wide{x != 0} : x >> places | wide{(x >> places) << places != x};
}
MEETC_HD constexpr double scaled(double x, int exponent) {
  for (; exponent > 0; --exponent)
    x *= 2;
  for (; exponent < 0; ++exponent)
    x *= 0.5;
  return x;
}

// The number of `precision` bits nearest to a raised x, in a format whose least positive number is 2^least.
MEETC_HD constexpr double nearest(const value &x, int precision, int least) {
  int top = 0;
  while (x.magnitude >> top > 1)
    ++top;
  const int by_precision = top - precision + 1, by_format = least - x.exponent;
  const int drop = by_precision > by_format ? by_precision : by_format; // the bits that go, at least 70
  const wide kept = lowered(x.magnitude, drop - 2); // with two more bits, the last of which stands for all below
  const wide odd = kept >> 2 & 1, rest = kept & 3;
  const auto rounded = static_cast<double>(static_cast<std::uint64_t>((kept >> 2) + (rest + odd > 2 ? 1 : 0)));
  return scaled(x.negative ? -rounded : rounded, x.exponent + drop);
}

// a b + c in a format of `precision` bits whose least positive number is 2^least, for a, b and c of that format.
MEETC_HD constexpr double fma(double a, double b, double c, int precision, int least) {
  const bool finite = a - a == 0 && b - b == 0 && c - c == 0;
  if (!finite || a == 0 || b == 0)
    return a * b + c;
  const value m = value_of(a), n = value_of(b), addend = value_of(c);
  value x = raised({m.magnitude * n.magnitude, m.exponent + n.exponent, m.negative != n.negative});
  if (c != 0) {
    value y = raised(addend);
    if (y.exponent > x.exponent || (y.exponent == x.exponent && y.magnitude > x.magnitude)) {
      const value other = x;
      x = y, y = other;
    }
    const wide moved = lowered(y.magnitude, x.exponent - y.exponent);
    x.magnitude = x.negative == y.negative ? x.magnitude + moved : x.magnitude - moved;
    if (x.magnitude == 0)
      return 0;
    x = raised(x);
  }
  return nearest(x, precision, least);
}

} // namespace constants

MEETC_HD constexpr float constant_fma(float a, float b, float c) {
  return static_cast<float>(constants::fma(a, b, c, 24, -149));
}
MEETC_HD constexpr double constant_fma(double a, double b, double c) {
  return constants::fma(a, b, c, 53, -1074);
}

} // MEETC_NAMESPACE(meetc)

#endif
