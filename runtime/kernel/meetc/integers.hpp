// Integers for the exact rung, and float32 numbers as integers on a common grid.
//
// A finite float32 is an integer times a power of two. The inputs of one decision are brought to one common power,
// and a homogeneous polynomial is then evaluated in integers that are wide enough by proof: no rounding, no
// overflow, no dependence on compiler flags or on the floating-point control word.
#ifndef MEETC_INTEGERS_HPP
#define MEETC_INTEGERS_HPP

#include <meetc/logic.hpp>

#include <cstring>

namespace meetc {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

// ---- float32 as integers ----

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

// Places of the lowest and the highest set bit of m > 0.
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
};
MEETC_HD inline grid grid_of(const float *v, int n) {
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
MEETC_HD inline void to_integer(float v, int low, std::int64_t &out) {
  const decoded d = decode(v);
  const int s = d.e - low;
  const std::int64_t m = d.m == 0 ? 0 : s >= 0 ? static_cast<std::int64_t>(d.m) << s : d.m >> -s;
  out = d.negative ? -m : m;
}
MEETC_HD inline void to_integer(float v, int low, int128 &out) {
  const decoded d = decode(v);
  const int s = d.e - low;
  const int128 m = d.m == 0 ? 0 : s >= 0 ? static_cast<int128>(d.m) << s : static_cast<int128>(d.m >> -s);
  out = d.negative ? -m : m;
}

// ---- integers of any width ----
//
// n limbs, least significant first, two's complement, modulo 2^(64 n): the caller's proof says that values fit. No
// templates over widths and, on the device, no calls: ptxas 13.0 miscompiles large kernels that call functions with
// many limbs in flight, and straight-line code in wide integers would be far larger than all the rest.

// v / 2^low, for a grid that holds v.
MEETC_HD inline void to_limbs(float v, int low, int n, std::uint64_t *out) {
  const decoded d = decode(v);
  MEETC_ROLLED
  for (int i = 0; i < n; ++i)
    out[i] = 0;
  if (d.m == 0)
    return;
  const int s = d.e - low;
  if (s < 0) {
    out[0] = d.m >> -s;
  } else {
    out[s / 64] = static_cast<std::uint64_t>(d.m) << s % 64;
    if (s % 64 > 40 && s / 64 + 1 < n)
      out[s / 64 + 1] = static_cast<std::uint64_t>(d.m) >> (64 - s % 64);
  }
  if (!d.negative)
    return;
  std::uint64_t carry = 1;
  MEETC_ROLLED
  for (int i = 0; i < n; ++i) {
    out[i] = ~out[i] + carry;
    carry = carry && out[i] == 0;
  }
}

// One step of a stage's program; r, a and b are places.
enum class step_kind : std::uint16_t {
  constant, // r = a + 2^16 b
  raise,    // r += 2^32 (a + 2^16 b)
  negate,   // r = -a
  add,      // r = a + b
  subtract, // r = a - b
  multiply, // r = a b; r is neither
  take_sign // the sign number r is that of a
};
struct step {
  step_kind kind;
  std::uint16_t r, a, b;
};

template <int Limbs> MEETC_HD inline void take_step(const step &t, int n, std::uint64_t (*place)[Limbs], sign *s) {
  const std::uint64_t *a = place[t.a], *b = place[t.b];
  if (t.kind == step_kind::take_sign) {
    std::uint64_t any = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i)
      any |= a[i];
    s[t.r] = a[n - 1] >> 63 ? sign::negative : any ? sign::positive : sign::zero;
    return;
  }
  std::uint64_t *r = place[t.r];
  switch (t.kind) {
  case step_kind::constant:
    MEETC_ROLLED
    for (int i = 0; i < n; ++i)
      r[i] = i ? 0 : t.a + (std::uint64_t{t.b} << 16);
    break;
  case step_kind::raise:
    r[0] += (t.a + (std::uint64_t{t.b} << 16)) << 32;
    break;
  case step_kind::add: {
    uint128 carry = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i) {
      carry += static_cast<uint128>(a[i]) + b[i];
      r[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    break;
  }
  case step_kind::multiply:
    MEETC_ROLLED
    for (int i = 0; i < n; ++i)
      r[i] = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i) {
      uint128 carry = 0;
      MEETC_ROLLED
      for (int j = 0; i + j < n; ++j) {
        carry += static_cast<uint128>(a[i]) * b[j] + r[i + j];
        r[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    break;
  default: { // negate, subtract
    std::uint64_t borrow = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i) {
      const std::uint64_t from = t.kind == step_kind::negate ? 0 : a[i],
                          what = t.kind == step_kind::negate ? a[i] : b[i];
      const std::uint64_t d = from - what;
      const std::uint64_t next = (from < what) | static_cast<std::uint64_t>(d < borrow);
      r[i] = d - borrow;
      borrow = next;
    }
  }
  }
}

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

} // namespace meetc

#endif
