// meet/support.hpp: the one header that generated code includes.
//
// Signs, three-valued answers, exact integers for the exact rung, and the plain types through which generated
// code meets a runtime. Host and device, C++20, no dependency but a compiler.
//
// Exactness: a finite float32 is an integer times a power of two. The inputs of one decision are brought to one
// common power, and a homogeneous polynomial is then evaluated in integers that are wide enough by proof: no
// rounding, no overflow, no dependence on compiler flags or on the floating-point control word.
#ifndef MEET_SUPPORT_HPP
#define MEET_SUPPORT_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>

#define MEET_SUPPORT_VERSION 1

#if defined(__FAST_MATH__)
#error "meet: -ffast-math breaks comparisons with NaN and infinities; compile without it"
#endif

#if defined(__CUDACC__)
#define MEET_HD __host__ __device__
#else
#define MEET_HD
#endif

// Wide integers are the rare path: kept out of line and rolled up, they cost little time and save much code.
#define MEET_NOINLINE __attribute__((noinline))
#if defined(__CUDA_ARCH__)
#define MEET_ROLLED _Pragma("unroll 1")
#else
#define MEET_ROLLED
#endif

namespace meet {

// ---- signs and answers -------------------------------------------------------------------------------------

enum class sign : signed char { negative = -1, zero = 0, positive = 1 };

// The answer of a decision under one rung. `unsure` goes to the next rung.
enum class answer : std::uint8_t { no = 0, yes = 1, unsure = 2 };

MEET_HD constexpr sign operator-(sign s) { return static_cast<sign>(-static_cast<int>(s)); }
MEET_HD constexpr sign operator*(sign a, sign b) {
  return static_cast<sign>(static_cast<int>(a) * static_cast<int>(b));
}
MEET_HD constexpr sign square(sign s) { return s * s; }

// A set of possible signs, as a rung with an error bound knows it: bit 0 negative, bit 1 zero, bit 2 positive.
struct sign_set {
  std::uint8_t bits;
  MEET_HD static constexpr sign_set all() { return {7}; }
  MEET_HD static constexpr sign_set of(sign s) {
    return {static_cast<std::uint8_t>(1 << (static_cast<int>(s) + 1))};
  }
};
MEET_HD constexpr sign_set operator-(sign_set s) {
  return {static_cast<std::uint8_t>((s.bits & 2) | (s.bits & 1) << 2 | s.bits >> 2)};
}
MEET_HD constexpr sign_set operator*(sign_set a, sign_set b) {
  const int n = (a.bits & 1 && b.bits & 4) || (a.bits & 4 && b.bits & 1);
  const int z = (a.bits & 2) || (b.bits & 2);
  const int p = (a.bits & 1 && b.bits & 1) || (a.bits & 4 && b.bits & 4);
  return {static_cast<std::uint8_t>(n | z << 1 | p << 2)};
}

MEET_HD constexpr sign_set square(sign_set s) {
  return {static_cast<std::uint8_t>((s.bits & 2) | ((s.bits & 5) != 0) << 2)};
}

// A three-valued truth: bit 0 can be false, bit 1 can be true.
struct truth {
  std::uint8_t bits;
  MEET_HD constexpr bool can_be_true() const { return (bits & 2) != 0; }
  MEET_HD constexpr bool can_be_false() const { return (bits & 1) != 0; }
};

// Branch-free connectives, alike for bool and truth (strong Kleene logic).
MEET_HD constexpr bool both(bool a, bool b) { return static_cast<bool>(a & b); }
MEET_HD constexpr bool either(bool a, bool b) { return static_cast<bool>(a | b); }
MEET_HD constexpr bool negate(bool a) { return !a; }
MEET_HD constexpr truth both(truth a, truth b) {
  return {static_cast<std::uint8_t>(((a.bits | b.bits) & 1) | (a.bits & b.bits & 2))};
}
MEET_HD constexpr truth either(truth a, truth b) {
  return {static_cast<std::uint8_t>((a.bits & b.bits & 1) | ((a.bits | b.bits) & 2))};
}
MEET_HD constexpr truth negate(truth a) { return {static_cast<std::uint8_t>((a.bits & 1) << 1 | a.bits >> 1)}; }
// A branch that is always taken is a plain bool beside truths.
MEET_HD constexpr truth to_truth(bool a) { return {static_cast<std::uint8_t>(a ? 2 : 1)}; }
MEET_HD constexpr truth both(truth a, bool b) { return both(a, to_truth(b)); }
MEET_HD constexpr truth both(bool a, truth b) { return both(to_truth(a), b); }
MEET_HD constexpr truth either(truth a, bool b) { return either(a, to_truth(b)); }
MEET_HD constexpr truth either(bool a, truth b) { return either(to_truth(a), b); }
MEET_HD constexpr bool can_be_true(bool a) { return a; }
MEET_HD constexpr bool can_be_true(truth a) { return a.can_be_true(); }
MEET_HD constexpr bool can_be_false(bool a) { return !a; }
MEET_HD constexpr bool can_be_false(truth a) { return a.can_be_false(); }
MEET_HD constexpr answer to_answer(bool a) { return a ? answer::yes : answer::no; }
MEET_HD constexpr answer to_answer(truth a) {
  return a.bits == 3 ? answer::unsure : a.can_be_true() ? answer::yes : answer::no;
}

// Whether a sign lies in the mask (1 negative, 2 zero, 4 positive): the comparisons < 0, <= 0, == 0 ...
template <int Mask> MEET_HD constexpr bool in(sign s) { return (Mask >> (static_cast<int>(s) + 1) & 1) != 0; }
template <int Mask> MEET_HD constexpr truth in(sign_set s) {
  return {static_cast<std::uint8_t>(((s.bits & ~Mask & 7) != 0) | ((s.bits & Mask) != 0) << 1)};
}

// ---- arithmetic that one emitted formula needs for every number type ----------------------------------------

MEET_HD inline float fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
MEET_HD inline double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }
template <class I> MEET_HD constexpr I fma(const I &a, const I &b, const I &c) { return a * b + c; }

template <class T> MEET_HD constexpr sign sign_of(const T &v) {
  return static_cast<sign>(static_cast<int>(v > T(0)) - static_cast<int>(v < T(0)));
}

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

// ---- rungs of a predicate ------------------------------------------------------------------------------------
//
// A predicate P has stages (reject, common, rare; absent ones are no_stage), each a program from stored numbers to
// signs: object_a and object_b compute what one object alone decides, pair the rest. P::rejected, P::usual,
// P::needs_rare and P::whole are its decision, for sign and for sign_set alike.

struct no_stage {
  static constexpr int atoms = 0;
};

template <class Stage, class T> MEET_HD inline void stage_signs(const T *a, const T *b, sign *s) {
  T fields_a[Stage::fields_a + 1], fields_b[Stage::fields_b + 1];
  fields_a[Stage::fields_a] = fields_b[Stage::fields_b] = T(0); // the spare places, for stages that store nothing
  Stage::object_a(a, fields_a);
  Stage::object_b(b, fields_b);
  Stage::pair(a, fields_a, b, fields_b, s);
}

// A plain rung takes the sign of the computed value.
template <class P, class T> struct plain_signs {
  T a[P::inputs_a], b[P::inputs_b];
  MEET_HD plain_signs(const float *row_a, const float *row_b) {
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = static_cast<T>(row_a[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = static_cast<T>(row_b[i]);
  }
  template <class Stage> MEET_HD void get(sign *s) const { stage_signs<Stage>(a, b, s); }
};

// The exact rung: integers on the grid of the pair's own numbers, as wide as the stage's bound asks for.
template <class P> struct exact_signs {
  const float *a, *b;
  grid common;
  MEET_HD exact_signs(const float *row_a, const float *row_b)
      : a(row_a), b(row_b), common(join(grid_of(row_a, P::inputs_a), grid_of(row_b, P::inputs_b))) {}

  template <class Stage> MEET_HD void get(sign *s) const {
    constexpr int most = Stage::degree * 277 + Stage::growth; // float32 spans 277 bits: 2^-149 to 2^128
    const int need = Stage::degree * common.bits() + Stage::growth;
    if (need <= 62)
      run<Stage, std::int64_t>(s);
    else if (need <= 126)
      run<Stage, int128>(s);
    else if (need <= 254)
      run<Stage, wide<4>>(s);
    else
      run<Stage, wide<most / 64 + 1>>(s);
  }

private:
  MEET_HD static grid join(grid x, grid y) {
    return {x.low < y.low ? x.low : y.low, x.high > y.high ? x.high : y.high};
  }
  template <class Stage, class I> MEET_HD void run(sign *s) const {
    I ia[P::inputs_a], ib[P::inputs_b];
    for (int i = 0; i < P::inputs_a; ++i)
      to_integer(a[i], common.low, ia[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      to_integer(b[i], common.low, ib[i]);
    stage_signs<Stage>(ia, ib, s);
  }
};

// Runs the stages in order and stops at the first that decides.
template <class P, class Signs> MEET_HD inline bool decide(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::reject_stage::atoms > 0) {
    signs.template get<typename P::reject_stage>(s);
    if (P::rejected(s))
      return false;
  }
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  if constexpr (P::rare_stage::atoms > 0)
    if (P::needs_rare(s)) {
      signs.template get<typename P::rare_stage>(s);
      return P::whole(s);
    }
  return P::usual(s);
}

// One sign, for kernels that are nothing else.
template <class P, class Signs> MEET_HD inline sign decide_sign(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  return P::value(s);
}

// ---- what a runtime and generated code tell each other --------------------------------------------------------

// What a stored number is, so that a runtime can move an element and check it without knowing its shape.
enum class role : std::uint8_t { x, y, z, length, other };

// One kind of element. A row is `fields` floats in the spec's store order.
struct kind_info {
  const char *name;
  const char *csv;   // the CSV header: the stored names, comma-separated
  int fields;        // floats a row
  const role *roles; // of each field
  int points;        // > 0: the row is that many points x, y, z and nothing else, so it can be indexed
  // A closed box that encloses the element, never too small (where subnormals are not flushed to zero).
  void (*box)(const float *row, float lo[3], float hi[3]);
  const char *(*fault)(const float *row);                  // the broken `where` rule, or null
};

struct index_pair {
  std::uint32_t a, b;
};

enum class rung : std::uint8_t { fp32 = 0, fp64 = 1, exact = 2 };
inline constexpr int rung_count = 3;

// One predicate on an ordered pair of kinds.
struct predicate_info {
  const char *name;
  const char *mode; // "solid", "surface", or "" where the two do not differ
  const kind_info *a, *b;
  // Decides n candidate pairs: pairs[i].a and .b index rows of a->fields and b->fields floats. Null where the
  // scene does not ask for the rung. Plain rungs and `exact` never answer unsure.
  void (*decide[rung_count])(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out);
};

// All that a namespace offers to a runtime.
struct catalogue {
  const char *space;
  const kind_info *kinds;
  int kind_count;
  const predicate_info *predicates;
  int predicate_count;
};

// The table's functions, for any predicate.
template <class P, class T>
void decide_plain(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = to_answer(decide<P>(plain_signs<P, T>(a + std::size_t{pairs[i].a} * P::inputs_a,
                                                   b + std::size_t{pairs[i].b} * P::inputs_b)));
}
template <class P>
void decide_exact(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = to_answer(decide<P>(exact_signs<P>(a + std::size_t{pairs[i].a} * P::inputs_a,
                                                b + std::size_t{pairs[i].b} * P::inputs_b)));
}

} // namespace meet

#endif
