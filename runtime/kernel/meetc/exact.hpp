// The exact rung: signs by integers, and by floating-point arithmetic where that is proved to be exact.
#ifndef MEETC_EXACT_HPP
#define MEETC_EXACT_HPP

#include <meetc/bytecode.hpp>
#include <meetc/usual.hpp>

MEETC_NAMESPACE(meetc) {

// Integers on the grid of the pair's own numbers, as wide as the stage needs. They depend neither on compiler flags nor
// on the control word.
template <class P> struct integer_signs {
  const float *a, *b;
  grid common;
  MEETC_HD integer_signs(const float *row_a, const float *row_b)
      : a(row_a), b(row_b), common(join(grid_of(row_a, P::inputs_a), grid_of(row_b, P::inputs_b))) {}

  template <class Stage> MEETC_HD void get(sign *s) const {
    const int need = Stage::degree * common.bits() + Stage::growth;
#if !defined(__CUDA_ARCH__)
    if (need <= 62)
      return run<Stage, std::int64_t>(s);
    if (need <= 126)
      return run<Stage, int128>(s);
#endif
    run_limbs<Stage>(need, s);
  }

private:
  template <class Stage, class I> MEETC_HD void run(sign *s) const {
    I ia[P::inputs_a], ib[P::inputs_b];
    for (int i = 0; i < P::inputs_a; ++i)
      to_integer(a[i], common.low, ia[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      to_integer(b[i], common.low, ib[i]);
    stage_signs<Stage>(ia, ib, s);
  }

  template <class Stage> MEETC_NOINLINE MEETC_HD void run_limbs(int need, sign *s) const {
    // Finite numbers span 277 bits, 2^-149 to 2^128. The bits of infinity and NaN are read as numbers below 2^129.
    constexpr int most = (Stage::degree * 278 + Stage::growth) / 64 + 1;
    std::uint64_t registers[Stage::bytecode::registers][most];
    const int limbs = need / 64 + 1; // and one bit for the sign
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_a; ++i)
      to_limbs(a[i], common.low, limbs, registers[i]);
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_b; ++i)
      to_limbs(b[i], common.low, limbs, registers[P::inputs_a + i]);
    MEETC_ROLLED
    for (int i = 0; i < Stage::bytecode::instruction_count; ++i)
      execute<most>(Stage::bytecode::instruction_at(i), limbs, registers, s + Stage::first);
  }
};

// The exact rung. Where the differences are short on their common grid, values up to degree 2 are exact in fp64 and the
// rest in double-double, without a branch. Elsewhere double-double with its bound is tried, and integers decide what is
// left. In an environment that is not the standard one, integers decide everything.
template <class P> struct exact_signs {
  const float *a, *b;
  grid common;
  bool standard;
  int bits; // of the differences on the grid; set where `standard`
  MEETC_HD exact_signs(const float *row_a, const float *row_b)
      : a(row_a), b(row_b), common(join(grid_of(row_a, P::inputs_a), grid_of(row_b, P::inputs_b))),
        standard(standard_environment()), bits(0) {
    if (standard) {
      a = after_check(a), b = after_check(b);
      bits = spread(a, b) - common.low;
    }
  }

  template <class Stage> MEETC_HD void get(sign *s) const {
    if (standard && computes_as_bounded()) {
      if (bits <= Stage::window) {
        using number = in_fp64::value; // no rounding happens, so that either schedule will do
        const rows_in<P, number> rows(a, b);
        if constexpr (Stage::mixed)
          stage_signs<Stage, number, in_fp64x2::value>(rows.a, rows.b, s);
        else
          stage_signs<Stage, number>(rows.a, rows.b, s);
        return;
      }
      sign_set sets[P::atoms];
      if (bounded_signs<P, in_fp64x2>(a, b).template get<Stage>(sets)) {
        known_signs<Stage>(sets, s);
        return;
      }
    }
    integer_signs<P>(a, b).template get<Stage>(s);
  }

private:
  // An e with |d| < 2^e for every difference d that the predicate forms and for every number that stands alone. On an
  // axis no difference exceeds the largest number less the least. Numbers that belong to no axis count twice, since
  // they may be subtracted from each other. -1000: all numbers are zero.
  MEETC_HD static int spread(const float *row_a, const float *row_b) {
    double low[4] = {0, 0, 0, 0}, high[4] = {0, 0, 0, 0};
    bool seen[4] = {false, false, false, false};
    const auto take = [&](double v, int axis) {
      const int k = axis < 0 || axis > 2 ? 3 : axis;
      if (k == 3) // a range from -2 |v| to 0
        v = v < 0 ? 2 * v : -2 * v;
      low[k] = seen[k] && low[k] < v ? low[k] : v;
      high[k] = k == 3 ? 0 : seen[k] && high[k] > v ? high[k] : v;
      seen[k] = true;
    };
    for (int i = 0; i < P::inputs_a; ++i)
      take(static_cast<double>(row_a[i]), P::axis(i));
    for (int i = 0; i < P::inputs_b; ++i)
      take(static_cast<double>(row_b[i]), P::axis(P::inputs_a + i));
    double widest = 0;
    for (int k = 0; k < 4; ++k)
      widest = high[k] - low[k] > widest ? high[k] - low[k] : widest;
    std::uint64_t word;
    std::memcpy(&word, &widest, sizeof word);
    return widest == 0 ? -1000 : static_cast<int>(word >> 52 & 0x7ff) - 1022; // < 2^e, also when rounded up to a power
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
