// The rung tolerant: answers that may be wrong only where moving one operand by at most the scene's tolerance changes
// them.
//
// There are two ways, and P::tolerance says which one the compiler has proved for the scene (gen/lower/tolerance.hpp).
//   by_grid      Each coordinate and each length is rounded to the nearest multiple of a power of two, and the decision on
//                the rounded numbers is exact. Within the scene's box these are integers so short that fp32 with its
//                bound, and then 64 or 128 bits, decide. No longer arithmetic is needed, nor any knowledge of how flat or
//                how parallel the operands are.
//   by_distance  The predicate compares the distance of two points with a sum of lengths, and the error of the plain value
//                in fp32 is less than the tolerance allows.
#ifndef MEETC_DECIDE_TOLERANT_HPP
#define MEETC_DECIDE_TOLERANT_HPP

#include <meetc/decide/decide.hpp>

MEETC_NAMESPACE(meetc) {

// Numbers are multiples of 2^Low, and no difference or length exceeds 2^Bits steps.
template <int Low, int Bits> struct by_grid {
  static constexpr bool rounds = true;
  static constexpr int low = Low, bits = Bits;
  static double step() { return std::ldexp(1.0, Low); }
};
struct by_distance {
  static constexpr bool rounds = false;
  static double step() { return 0; }
  // Products and sums are written one by one, so that no machine calls a function. Compiled with -ffp-contract=off, as our
  // libraries are, each is rounded, and all machines give the same answers.
  using number = unfused<float>;
};

// A scene may have predicates that keep no tolerance.
template <class P> inline constexpr bool keeps_tolerance = requires {
  typename P::tolerance;
};

// The multiple of 2^low nearest to a finite v; of two, the even one. Every step is exact, so that neither flags nor the
// environment matter. The result is infinite if it exceeds float32.
MEETC_HD inline float nearest_multiple(float v, int low) {
  const decoded d = decode(v);
  const int drop = low - d.e; // bits below the step
  if (drop <= 0 || d.m == 0)
    return v;
  std::uint32_t steps = 0; // |v| < 2^24 units, so that a longer step is more than twice as long
  if (drop <= 24) {
    steps = d.m >> drop;
    const std::uint32_t rest = d.m & ((1U << drop) - 1), half = 1U << (drop - 1);
    steps += rest > half || (rest == half && (steps & 1) != 0);
  }
  // steps <= 2^24 of 2^low, as bits of a float32.
  std::uint32_t word = 0;
  if (steps != 0) {
    const int top = highest_bit(steps), exponent = low + top; // steps is from 2^top
    if (exponent > 127)
      word = 0x7f800000;
    else if (exponent >= -126)
      word = (static_cast<std::uint32_t>(exponent + 127) << 23) |
             ((top <= 23 ? steps << (23 - top) : steps >> (top - 23)) & 0x7fffff);
    else // drop > 0, so that low is above -149, and no bit is lost
      word = steps << (low + 149);
  }
  if (d.negative)
    word |= 0x80000000;
  float out;
  std::memcpy(&out, &word, sizeof out);
  return out;
}

// Exact signs of rows on the grid, in any environment. The widths fit by proof.
template <class P> struct grid_signs {
  const float *a, *b;
  template <class Stage> MEETC_HD void get(sign *s) const {
    using presumed = typename P::tolerance;
    constexpr int need = Stage::degree * presumed::bits + Stage::growth;
    constexpr bool quick = Stage::mixed && 2 * presumed::bits + Stage::growth <= 62;
    static_assert(need <= 126, "the scene's grid is too fine for 128 bits");
    using wide = std::conditional_t<need <= 62, std::int64_t, int128>;
    using narrow = std::conditional_t<need <= 62 || quick, std::int64_t, int128>;
    const int low = presumed::low; // a reference to the member itself would need it in the device's memory
    integer_stage_signs<P, Stage, narrow, wide>(a, b, low, s);
  }
};

// The decision on a pair that fp32 leaves open: exact, of rows on the grid; by distance, from the value in fp64, for
// environments in which the bound in fp32 does not hold. Few pairs need it.
template <class P> MEETC_HD inline bool tolerant_later_rungs(const float *row_a, const float *row_b) {
  if constexpr (P::tolerance::rounds)
    return decide<P>(grid_signs<P>{row_a, row_b});
  else
    return decide<P>(plain_signs<P, double>(row_a, row_b));
}
// The decision on rows, which have been rounded if the rung rounds.
template <class P> MEETC_HD inline bool decide_tolerant(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return tolerant_later_rungs<P>(row_a, row_b);
  row_a = after_check(row_a), row_b = after_check(row_b);
  if constexpr (P::tolerance::rounds) {
    const first_answer by_fp32 = look<P, in_fp32>(row_a, row_b);
    return before_return(by_fp32 == first_answer::no || by_fp32 == first_answer::yes
                             ? by_fp32 == first_answer::yes
                             : tolerant_later_rungs<P>(row_a, row_b));
  } else {
    return before_return(decide<P>(plain_signs<P, by_distance::number>(row_a, row_b)));
  }
}

// A number of an operand, or the nearest one within the reach, so that integers never overflow. NaN counts as 0.
MEETC_HD inline float within_reach(float v, double reach) {
  const double x = static_cast<double>(v);
  return x > reach ? static_cast<float>(reach) : x < -reach ? static_cast<float>(-reach) : x == x ? v : 0.0F;
}
template <class P, bool First> MEETC_HD inline void round_row(float *row, int fields) {
  for (int i = 0; i < fields; ++i) {
    const bool length = P::axis(First ? i : P::inputs_a + i) < 0;
    row[i] = within_reach(nearest_multiple(row[i], P::tolerance::low), P::tolerance::reach * (length ? 2 : 1));
  }
}

// Operands as they are stored, in the scene's box: all numbers, which are coordinates and lengths, are rounded first.
template <class P, class A, class B> MEETC_HD inline bool hit_tolerant(const A &x, const B &y) {
  float row_a[P::inputs_a], row_b[P::inputs_b];
  to_row(x, row_a), to_row(y, row_b);
  if constexpr (P::tolerance::rounds) {
    round_row<P, true>(row_a, P::inputs_a);
    round_row<P, false>(row_b, P::inputs_b);
  }
#if defined(__CUDA_ARCH__)
  return decide_tolerant<P>(row_a, row_b);
#else
  if (!standard_environment())
    return P::tolerant_rest(row_a, row_b);
  const float *const a = after_check(static_cast<const float *>(row_a)), *const b = after_check(
                                                                             static_cast<const float *>(row_b));
  if constexpr (!P::tolerance::rounds) {
    return before_return(decide<P>(plain_signs<P, by_distance::number>(a, b)));
  } else {
    const first_answer by_fp32 = look<P, in_fp32>(a, b);
    if (by_fp32 == first_answer::no || by_fp32 == first_answer::yes)
      return before_return(by_fp32 == first_answer::yes);
    return P::tolerant_rest(a, b);
  }
#endif
}

} // MEETC_NAMESPACE(meetc)

#endif
