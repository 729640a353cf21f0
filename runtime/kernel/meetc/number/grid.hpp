// float32 numbers as integers on a common grid.
//
// A finite float32 is an integer times a power of two. The inputs of one decision are brought to one common power,
// and a homogeneous polynomial is then evaluated in integers that are wide enough by proof: no rounding, no
// overflow, no dependence on compiler flags or on the floating-point control word.
#ifndef MEETC_NUMBER_GRID_HPP
#define MEETC_NUMBER_GRID_HPP

#include <meetc/number/logic.hpp>

#include <cstring>

MEETC_NAMESPACE(meetc) {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

// m * 2^e = |v|, m < 2^24. v finite.
struct decoded {
  std::uint32_t m;
  int e;
  bool negative;
};
MEETC_HD inline decoded decode(float v) {
  std::uint32_t b;
  std::memcpy(&b, &v, sizeof b);
  const std::uint32_t exponent = b >> 23 & 0xff, fraction = b & 0x7fffff;
  return {exponent ? fraction | 0x800000 : fraction, static_cast<int>(exponent ? exponent : 1) - 150, b >> 31 != 0};
}

// The positions of the lowest and the highest set bit of m > 0.
MEETC_HD inline int lowest_bit(std::uint32_t m) {
#if defined(__CUDA_ARCH__)
  return __ffs(static_cast<int>(m)) - 1;
#else
  return __builtin_ctz(m);
#endif
}
MEETC_HD inline int highest_bit(std::uint32_t m) {
#if defined(__CUDA_ARCH__)
  return 31 - __clz(static_cast<int>(m));
#else
  return 31 - __builtin_clz(m);
#endif
}

// The common grid of some float32 numbers: each is an integer below 2^bits in magnitude, times 2^low.
struct grid {
  int low, high; // high: one past the exponent of the highest set bit; low >= high when all are zero
  MEETC_HD int bits() const { return high > low ? high - low : 0; }
  MEETC_HD bool finite() const { return high <= 128; } // the bits of infinity and NaN are read as numbers from 2^128 on
};
MEETC_HD inline grid grid_of(const float *v, int n) {
  std::uint32_t largest = 0; // as bits, which order magnitudes
  int low = 1000;
  for (int i = 0; i < n; ++i) {
    std::uint32_t b;
    std::memcpy(&b, v + i, sizeof b);
    b &= 0x7fffffff;
    largest = b > largest ? b : largest;
    const decoded d = decode(v[i]);
    const int lowest = d.e + lowest_bit(d.m | 0x1000000); // of zero: not used
    low = d.m != 0 && lowest < low ? lowest : low;
  }
  if (largest == 0)
    return {1000, -1000};
  const std::uint32_t exponent = largest >> 23;
  return {low, exponent ? static_cast<int>(exponent) - 126 : highest_bit(largest) - 148};
}
MEETC_HD inline grid join(grid x, grid y) {
  return {x.low < y.low ? x.low : y.low, x.high > y.high ? x.high : y.high};
}

// v / 2^low as an integer, for a grid that holds v. Without branches, which numbers of all sizes would mislead.
template <class I> MEETC_HD inline void to_integer(float v, int low, I &out) {
  const decoded d = decode(v);
  const int s = d.e - low; // zero may have any
  const int left = d.m != 0 && s > 0 ? s : 0, right = s < 0 ? (-s & 31) : 0;
  const I m = static_cast<I>(d.m >> right) << left, negative = -static_cast<I>(d.negative);
  out = (m ^ negative) - negative;
}

} // MEETC_NAMESPACE(meetc)

#endif
