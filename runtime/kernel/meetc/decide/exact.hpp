// The exact rung: signs by integers, and by floating-point arithmetic where that is proved to be exact.
#ifndef MEETC_DECIDE_EXACT_HPP
#define MEETC_DECIDE_EXACT_HPP

#include <meetc/decide/bytecode.hpp>
#include <meetc/decide/first_stages.hpp>
#include <meetc/decide/integers.hpp>

MEETC_NAMESPACE(meetc) {

// An e with |d| < 2^e for every difference d that the predicate forms and for every number that stands alone. On an
// axis no difference exceeds the largest number less the least. Numbers that belong to no axis count twice, since they
// may be subtracted from each other. -1000: all numbers are zero.
template <class P> MEETC_HD inline int spread(const float *row_a, const float *row_b) {
  float low[4], high[4]; // by axis; 3: numbers that belong to none
  for (int axis = 0; axis < 4; ++axis)
    low[axis] = HUGE_VALF, high[axis] = -HUGE_VALF;
  each_input<P>(row_a, row_b, [&]<int Axis>(float v) {
    constexpr int k = Axis < 0 || Axis > 2 ? 3 : Axis;
    low[k] = v < low[k] ? v : low[k];
    high[k] = v > high[k] ? v : high[k];
  });
  double widest = 0;
  for (int axis = 0; axis < 4; ++axis) {
    const double x = low[axis], y = high[axis];
    const double most = axis < 3 ? y - x : 2 * (-x > y ? -x : y);
    widest = most > widest ? most : widest; // an axis without numbers has -infinity
  }
  std::uint64_t word;
  std::memcpy(&word, &widest, sizeof word);
  return widest == 0 ? -1000 : static_cast<int>(word >> 52 & 0x7ff) - 1022; // < 2^e, also when rounded up to a power
}

// An e with |d| < 2^(w e) units for every number and difference of numbers of weight w.
template <class P>
MEETC_HD inline int bits_of_differences(const pair_grid<P> &g, [[maybe_unused]] const float *row_a,
                                        [[maybe_unused]] const float *row_b) {
  if constexpr (grouped<P>)
    return g.bits() + 1;
  else
    return spread<P>(row_a, row_b) - g.low;
}

// Whether nothing under- or overflows in doubles that hold the values of a stage. Up to degree 6 nothing does.
template <class Stage, class Grid> MEETC_HD inline bool fits_doubles(const Grid &g, int bits) {
  if constexpr (Stage::degree > 6) {
    const exponent_range r = range_of(g, bits);
    return r.low * Stage::degree >= -960 && r.high * Stage::degree + Stage::growth <= 960;
  }
  return true;
}

// Integers on the grid of the pair's own numbers, as wide as the stage needs. They depend neither on compiler flags nor
// on the control word.
template <class P> struct integer_signs {
  const float *a, *b;
  pair_grid<P> common;
  int bits; // of the differences, or of the numbers
  MEETC_HD integer_signs(const float *row_a, const float *row_b)
      : a(row_a), b(row_b), common(grid_of_pair<P>(row_a, row_b)), bits(common.bits()) {}
  // The same for a known grid on which the differences are integers below 2^of_differences.
  MEETC_HD integer_signs(const float *row_a, const float *row_b, const pair_grid<P> &of_both, int of_differences)
      : a(row_a), b(row_b), common(of_both), bits(of_differences < of_both.bits() ? of_differences : of_both.bits()) {}

  // The bits that the stage's values need, without their sign.
  template <class Stage> MEETC_HD int need() const { return Stage::degree * (bits > 0 ? bits : 0) + Stage::growth; }
  // Whether they are computed in 64 or 128 bits.
  template <class Stage> MEETC_HD bool is_short() const {
#if defined(__CUDA_ARCH__)
    return false;
#else
    return need<Stage>() <= 126 && common.bits() <= 126;
#endif
  }

  // Whether values up to degree 2 are computed in 64 bits, and the others in 128. A stage can mix the two if the values
  // of one object, which have the shorter type, are of degree 2 at most.
  template <class Stage> MEETC_HD bool is_quick() const {
    return Stage::mixed && is_short<Stage>() && 2 * bits + Stage::growth <= 62 && common.bits() <= 62;
  }

  template <class Stage> MEETC_HD void get(sign *s) const {
#if !defined(__CUDA_ARCH__)
    if (need<Stage>() <= 62 && common.bits() <= 62)
      return run<Stage, std::int64_t, std::int64_t>(s);
    if (is_quick<Stage>())
      return run<Stage, std::int64_t, int128>(s);
    if (is_short<Stage>())
      return run<Stage, int128, int128>(s);
#endif
    run_limbs<Stage>(Stage::degree * common.bits() + Stage::growth, s);
  }

private:
  template <class Stage, class I, class W> MEETC_HD void run(sign *s) const {
    integer_stage_signs<P, Stage, I, W>(a, b, common, s);
  }

  template <class Stage> MEETC_NOINLINE MEETC_HD void run_limbs(int wanted, sign *s) const {
    // Finite numbers span 277 bits, 2^-149 to 2^128. The bits of infinity and NaN are read as numbers below 2^129.
    constexpr int most = (Stage::degree * 278 + Stage::growth) / 64 + 1;
    std::uint64_t registers[Stage::bytecode::registers][most];
    const int limbs = wanted / 64 + 1; // and one bit for the sign
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_a; ++i)
      to_limbs(as_read<P>(a[i], i), unit_of(common, i), limbs, registers[i]);
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_b; ++i)
      to_limbs(as_read<P>(b[i], P::inputs_a + i), unit_of(common, P::inputs_a + i), limbs, registers[P::inputs_a + i]);
    MEETC_ROLLED
    for (int i = 0; i < Stage::bytecode::instruction_count; ++i)
      execute<most>(Stage::bytecode::instruction_at(i), limbs, registers, s + Stage::first);
  }
};

// The signs of a stage in fp64 and double-double, for differences within its window: they are exact there.
template <class P, class Stage>
MEETC_HD MEETC_INLINE void signs_in_window(const float *row_a, const float *row_b, sign *s) {
  using number = in_fp64::value; // nothing is rounded, so that either schedule will do
  const rows_in<P, number> rows(row_a, row_b);
  if constexpr (Stage::mixed)
    stage_signs<Stage, number, in_fp64x2::value>(rows.a, rows.b, s);
  else
    stage_signs<Stage, number>(rows.a, rows.b, s);
}

// The signs of the rung fp64. The bound comes first, since it decides most pairs. It cannot decide a zero, and zeros
// seldom come alone: once a sign is unsure, this stage and those after it are computed exactly if the differences of
// the pair are within their windows.
template <class P> struct fp64_signs {
  bounded_signs<P, in_fp64> bounded;
  mutable int bits = unmeasured; // of the differences on the grid
  MEETC_HD fp64_signs(const float *row_a, const float *row_b) : bounded(row_a, row_b) {}
  MEETC_HD std::uint32_t equal() const { return bounded.equal(); }

  template <class Stage> MEETC_HD MEETC_INLINE bool get(sign_set *all) const {
    return by_bounds<Stage>(all) || zero_by_equal_points<P, Stage>(equal(), all);
  }
  template <class Stage> MEETC_HD MEETC_INLINE bool by_bounds(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    if (bits != unmeasured && in_window<Stage>())
      return exactly<Stage>(all);
    in_fp64::value v[Stage::atoms], m[Stage::atoms];
    bounded.template compute<Stage>(v, m);
    if (bounded.template sort_out<Stage>(v, m, all))
      return true;
    if (bits == unmeasured)
      bits = measure(bounded.row_a, bounded.row_b);
    return in_window<Stage>() ? exactly<Stage>(all) : bounded.template zero_by_grid<Stage>(v, m, all);
  }

private:
  static constexpr int unmeasured = -5000;
  MEETC_NOINLINE MEETC_HD static int measure(const float *a, const float *b) {
    return bits_of_differences<P>(grid_of_pair<P>(a, b), a, b);
  }
  template <class Stage> MEETC_HD MEETC_INLINE bool in_window() const {
    if constexpr (Stage::degree <= 6)
      return bits <= Stage::window;
    else
      return bits <= Stage::window && fits_doubles<Stage>(grid_of_pair<P>(bounded.row_a, bounded.row_b), bits);
  }
  template <class Stage> MEETC_NOINLINE MEETC_HD bool exactly(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    sign s[P::atoms];
    signs_in_window<P, Stage>(bounded.row_a, bounded.row_b, s);
    for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
      all[i] = sign_set::of(s[i]);
    return true;
  }
};

// The exact rung. Each stage takes the cheapest way that is exact for the pair.
//   1. If the differences span few enough bits of the pair's grid (the window; the lowest set bit tests it), values of
//      degree 1 and 2 are exact in fp64 and the rest in double-double, without a branch. The generator proves the
//      windows; the shipped ones are 26 bits for points, segments and triangles among themselves (degree 3), 25 for
//      spheres and balls among themselves (degree 2), 23 for a sphere or ball with a segment (degree 4), and 7 for one
//      with a triangle (degree 6, in fp64 alone, since a triangle's own values reach degree 3 and more).
//   2. Otherwise integers of 64 or 128 bits decide if they are proved wide enough: the values need degree times b bits,
//      and the stage's growth, for differences of b bits, so 128 bits hold differences of 40 bits in degree 3.
//      Coordinates are taken from the first one along their axis, so that large coordinates with short differences are
//      short too. If values up to degree 2 fit in 64 bits and the others in 128, a product of two short numbers is one
//      instruction; that is faster than double-double, and comes before step 1. Devices have no integers of 128 bits
//      and leave this step out.
//   3. For wider numbers double-double with its bound and the grid decides all that is not within about 2^-100 of zero.
//   4. The rest is computed in as many 64-bit limbs as the degree asks for the grid of the pair (bytecode.hpp).
// In an environment that is not the standard one, integers decide everything.
template <class P> struct exact_signs {
  const float *a, *b;
  pair_grid<P> common;
  bool standard;
  bool bound_failed; // double-double with its bound has not decided the pair, and is not tried again
  int bits;          // of the differences on the grid if `standard`, else of the numbers
  MEETC_HD exact_signs(const float *row_a, const float *row_b, bool after_fp64x2 = false)
      : a(row_a), b(row_b), common(grid_of_pair<P>(row_a, row_b)), standard(standard_environment()),
        bound_failed(after_fp64x2), bits(common.bits()) {
    if (standard) {
      a = after_check(a), b = after_check(b);
      if (common.finite()) // no difference bounds the integers that the bits of infinity and NaN are read as
        bits = bits_of_differences<P>(common, a, b);
    }
  }

  template <class Stage> MEETC_HD void get(sign *s) const {
    const integer_signs<P> integers(a, b, common, bits);
    if (standard && computes_as_bounded()) {
      if (bits <= Stage::window && fits_doubles<Stage>(common, bits) && !integers.template is_quick<Stage>())
        return signs_in_window<P, Stage>(a, b, s);
      sign_set sets[P::atoms];
      if (!bound_failed && !integers.template is_short<Stage>() &&
          bounded_signs<P, in_fp64x2>(a, b).template get<Stage>(sets)) {
        known_signs<Stage>(sets, s);
        return;
      }
    }
    integers.template get<Stage>(s);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
