// Integers for the exact rung, and float32 numbers as integers on a common grid.
//
// A finite float32 is an integer times a power of two. The inputs of one decision are brought to one common power,
// and a homogeneous polynomial is then evaluated in integers that are wide enough by proof: no rounding, no
// overflow, no dependence on compiler flags or on the floating-point control word.
#ifndef MEET_INTEGERS_HPP
#define MEET_INTEGERS_HPP

#include <meet/logic.hpp>

#include <cstring>

namespace meet {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

// A two's complement integer of 64*W bits, least significant limb first. Arithmetic is modulo 2^(64 W); the
// caller's proof says that values fit.
template <int W> struct wide {
  std::uint64_t limb[W];

  wide() = default;
  MEET_HD constexpr explicit wide(std::int64_t v) : limb() {
    limb[0] = static_cast<std::uint64_t>(v);
    MEET_ROLLED
    for (int i = 1; i < W; ++i)
      limb[i] = v < 0 ? ~std::uint64_t{0} : 0;
  }
  MEET_NOINLINE MEET_HD friend constexpr wide operator+(const wide &a, const wide &b) {
    wide r(0);
    uint128 carry = 0;
    MEET_ROLLED
    for (int i = 0; i < W; ++i) {
      carry += static_cast<uint128>(a.limb[i]) + b.limb[i];
      r.limb[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return r;
  }
  MEET_HD friend constexpr wide operator-(const wide &a) { return wide(0) - a; }
  MEET_NOINLINE MEET_HD friend constexpr wide operator-(const wide &a, const wide &b) {
    wide r(0);
    std::uint64_t borrow = 0;
    MEET_ROLLED
    for (int i = 0; i < W; ++i) {
      const std::uint64_t d = a.limb[i] - b.limb[i];
      const std::uint64_t next = (a.limb[i] < b.limb[i]) | static_cast<std::uint64_t>(d < borrow);
      r.limb[i] = d - borrow;
      borrow = next;
    }
    return r;
  }
  MEET_NOINLINE MEET_HD friend constexpr wide operator*(const wide &a, const wide &b) {
    wide r(0);
    MEET_ROLLED
    for (int i = 0; i < W; ++i) {
      uint128 carry = 0;
      MEET_ROLLED
      for (int j = 0; i + j < W; ++j) {
        carry += static_cast<uint128>(a.limb[i]) * b.limb[j] + r.limb[i + j];
        r.limb[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return r;
  }
};
template <int W> MEET_HD constexpr sign sign_of(const wide<W> &v) {
  if (v.limb[W - 1] >> 63)
    return sign::negative;
  std::uint64_t any = 0;
  for (int i = 0; i < W; ++i)
    any |= v.limb[i];
  return any ? sign::positive : sign::zero;
}

// ---- float32 as integers -------------------------------------------------------------------------------------

// m * 2^e = |v|, m < 2^24. v finite.
struct decoded {
  std::uint32_t m;
  int e;
  bool negative;
};
MEET_HD inline decoded decode(float v) {
  std::uint32_t b;
  std::memcpy(&b, &v, sizeof b);
  const std::uint32_t exponent = b >> 23 & 0xff, fraction = b & 0x7fffff;
  return {exponent ? fraction | 0x800000 : fraction, static_cast<int>(exponent ? exponent : 1) - 150, b >> 31 != 0};
}

// Places of the lowest and the highest set bit of m > 0.
MEET_HD inline int lowest_bit(std::uint32_t m) {
#if defined(__CUDA_ARCH__)
  return __ffs(static_cast<int>(m)) - 1;
#else
  return __builtin_ctz(m);
#endif
}
MEET_HD inline int highest_bit(std::uint32_t m) {
#if defined(__CUDA_ARCH__)
  return 31 - __clz(static_cast<int>(m));
#else
  return 31 - __builtin_clz(m);
#endif
}

// The common grid of some float32 numbers: each is an integer below 2^bits in magnitude, times 2^low.
struct grid {
  int low, high; // high: one past the exponent of the highest set bit; low >= high when all are zero
  MEET_HD int bits() const { return high > low ? high - low : 0; }
};
MEET_HD inline grid grid_of(const float *v, int n) {
  grid g{1000, -1000};
  for (int i = 0; i < n; ++i) {
    const decoded d = decode(v[i]);
    if (d.m == 0)
      continue;
    const int low = d.e + lowest_bit(d.m), high = d.e + highest_bit(d.m) + 1;
    g.low = low < g.low ? low : g.low;
    g.high = high > g.high ? high : g.high;
  }
  return g;
}

// v / 2^low as an integer, for a grid that holds v.
MEET_HD inline void to_integer(float v, int low, std::int64_t &out) {
  const decoded d = decode(v);
  const int s = d.e - low;
  const std::int64_t m = d.m == 0 ? 0 : s >= 0 ? static_cast<std::int64_t>(d.m) << s : d.m >> -s;
  out = d.negative ? -m : m;
}
MEET_HD inline void to_integer(float v, int low, int128 &out) {
  const decoded d = decode(v);
  const int s = d.e - low;
  const int128 m = d.m == 0 ? 0 : s >= 0 ? static_cast<int128>(d.m) << s : static_cast<int128>(d.m >> -s);
  out = d.negative ? -m : m;
}
template <int W> MEET_NOINLINE MEET_HD inline void to_integer(float v, int low, wide<W> &out) {
  const decoded d = decode(v);
  out = wide<W>(0);
  if (d.m == 0)
    return;
  const int s = d.e - low;
  if (s < 0) {
    out.limb[0] = d.m >> -s;
  } else {
    out.limb[s / 64] = static_cast<std::uint64_t>(d.m) << s % 64;
    if (s % 64 > 40 && s / 64 + 1 < W)
      out.limb[s / 64 + 1] = static_cast<std::uint64_t>(d.m) >> (64 - s % 64);
  }
  if (d.negative)
    out = -out;
}

// The neighbours of v, for boxes that must enclose: a rounded sum is at most one step from the true one.
MEET_HD inline float step_up(float v) {
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
MEET_HD inline float step_down(float v) { return -step_up(-v); }

} // namespace meet

#endif
