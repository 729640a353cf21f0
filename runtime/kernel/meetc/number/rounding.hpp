// The neighbours of float32 numbers and the powers of two above them, by operations on bits.
#ifndef MEETC_NUMBER_ROUNDING_HPP
#define MEETC_NUMBER_ROUNDING_HPP

#include <meetc/number/double_double.hpp>

#include <cstring>

MEETC_NAMESPACE(meetc) {

// The neighbours of v, for boxes that must enclose: a rounded sum is at most one step from the true one.
MEETC_HD inline float step_up(float v) {
  std::uint32_t b;
  std::memcpy(&b, &v, sizeof b);
  if ((b & 0x7fffffff) == 0)
    b = 1;
  else if (b == 0x7f800000)
    return v;
  else
    b = b >> 31 ? b - 1 : b + 1;
  std::memcpy(&v, &b, sizeof b);
  return v;
}
MEETC_HD inline float step_down(float v) {
  return -step_up(-v);
}
MEETC_HD inline float least_of(float a, float b) {
  return b < a ? b : a;
}
MEETC_HD inline float most_of(float a, float b) {
  return a < b ? b : a;
}

// The larger of m and |x|; NaN if x is NaN.
MEETC_HD MEETC_INLINE float larger(float m, float x) {
  const float a = magnitude_of(x);
  return a <= m ? m : a;
}

// The least power of two that is not below x >= 0. Infinity and NaN are returned as they are.
MEETC_HD inline float power_above(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  if (b < 0x7f800000 && (b & 0x7fffff))
    b = (b & 0x7f800000) + 0x800000;
  std::memcpy(&x, &b, sizeof b);
  return x;
}

// The least power of two that is above x >= 0. Infinity and NaN are returned as they are.
MEETC_HD inline float power_over(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  if (b < 0x7f800000)
    b = (b & 0x7f800000) + 0x800000;
  std::memcpy(&x, &b, sizeof b);
  return x;
}

} // MEETC_NAMESPACE(meetc)

#endif
