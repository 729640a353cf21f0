// The interpreter of a stage's bytecode, on integers of any width.
#ifndef MEETC_DECIDE_BYTECODE_HPP
#define MEETC_DECIDE_BYTECODE_HPP

#include <meetc/number/grid.hpp>

MEETC_NAMESPACE(meetc) {

//
// Integers have n limbs, least significant first, in two's complement modulo 2^(64 n); the caller's proof says that
// values fit. The width is not a template parameter, and on the device nothing is called: ptxas 13.0 miscompiles large
// kernels that call functions with many limbs in flight, and straight-line code in wide integers would be far larger
// than everything else.

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

// One instruction of a stage's program; r, a and b are registers.
enum class opcode : std::uint16_t {
  constant, // r = a + 2^16 b
  raise,    // r += 2^32 (a + 2^16 b)
  negate,   // r = -a
  add,      // r = a + b
  subtract, // r = a - b
  multiply, // r = a b; r is neither a nor b
  take_sign // sign number r is the sign of a
};
struct instruction {
  opcode code;
  std::uint16_t r, a, b;
};

template <int Limbs>
MEETC_HD inline void execute(const instruction &t, int n, std::uint64_t (*registers)[Limbs], sign *s) {
  const std::uint64_t *a = registers[t.a], *b = registers[t.b];
  if (t.code == opcode::take_sign) {
    std::uint64_t any = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i)
      any |= a[i];
    s[t.r] = a[n - 1] >> 63 ? sign::negative : any ? sign::positive : sign::zero;
    return;
  }
  std::uint64_t *r = registers[t.r];
  switch (t.code) {
  case opcode::constant:
    MEETC_ROLLED
    for (int i = 0; i < n; ++i)
      r[i] = i ? 0 : t.a + (std::uint64_t{t.b} << 16);
    break;
  case opcode::raise:
    r[0] += (t.a + (std::uint64_t{t.b} << 16)) << 32;
    break;
  case opcode::add: {
    uint128 carry = 0;
    MEETC_ROLLED
    for (int i = 0; i < n; ++i) {
      carry += static_cast<uint128>(a[i]) + b[i];
      r[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    break;
  }
  case opcode::multiply:
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
      const std::uint64_t from = t.code == opcode::negate ? 0 : a[i], what = t.code == opcode::negate ? a[i] : b[i];
      const std::uint64_t d = from - what;
      const std::uint64_t next = (from < what) | static_cast<std::uint64_t>(d < borrow);
      r[i] = d - borrow;
      borrow = next;
    }
  }
  }
}

} // MEETC_NAMESPACE(meetc)

#endif
