// The semi-static filter: signs of values with an error bound that is computed beside them, from magnitudes.
#ifndef MEETC_DECIDE_BOUNDS_HPP
#define MEETC_DECIDE_BOUNDS_HPP

#include <meetc/decide/pair_grid.hpp>
#include <meetc/decide/stages.hpp>

#include <cmath>

MEETC_NAMESPACE(meetc) {

// ---- with an error bound ----

// K in |computed - true| <= K M, where M is the magnitude of the value, for each arithmetic.
struct factors {
  float fp32;
  double fp64, fp64x2;
};
// The bound c alpha^a beta^b D^pair of a value in fp32, inside a box.
struct box_factor {
  float c;
  signed char a, b, pair;
};

// The three arithmetics with bounds, each with and without the fused multiply-add. `real` is the type of the thresholds.
template <class T, bool Fused> using bounded_number = std::conditional_t<Fused, T, unfused<T>>;
template <bool Fused, class Stage> MEETC_HD constexpr factors factors_of(int i) {
  return Fused ? Stage::factor(i) : Stage::factor_unfused(i);
}
template <bool Fused> struct fp32_arithmetic {
  using real = float;
  using value = bounded_number<float, Fused>;
  using magnitude = value;
  template <class Stage> MEETC_HD static constexpr float factor(int i) { return factors_of<Fused, Stage>(i).fp32; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp32; }
  template <class Stage> MEETC_HD static constexpr box_factor box(int i) {
    return Fused ? Stage::box(i) : Stage::box_unfused(i);
  }
};
template <bool Fused> struct fp64_arithmetic {
  using real = double;
  using value = bounded_number<double, Fused>;
  using magnitude = value;
  template <class Stage> MEETC_HD static constexpr double factor(int i) { return factors_of<Fused, Stage>(i).fp64; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp64; }
};
template <bool Fused> struct fp64x2_arithmetic {
  using real = double;
  using value = double_words<Fused>;
  using magnitude = bounded_number<double, Fused>;
  template <class Stage> MEETC_HD static constexpr double factor(int i) { return factors_of<Fused, Stage>(i).fp64x2; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp64; }
};
// Those of this compilation. Functions that differ between compilations have the arithmetic in their names.
using in_fp32 = fp32_arithmetic<MEETC_FUSES>;
using in_fp64 = fp64_arithmetic<MEETC_FUSES>;
using in_fp64x2 = fp64x2_arithmetic<MEETC_FUSES>;

// 2^e in the type T, e <= 0.
template <class T> MEETC_HD MEETC_INLINE constexpr T power_of_two(int e, T) {
  T r = 1;
  for (; e < 0; ++e)
    r *= T(0.5);
  return r;
}

// The magnitude of a leaf: at least `floor`, so that no product of magnitudes underflows, but zero stays zero: a
// magnitude of zero proves a value of zero.
template <class M> struct leaf_magnitude {
  M floor;
  MEETC_HD MEETC_INLINE M operator()(M difference) const {
    const M m = magnitude_of(difference);
    return m == M(0) ? M(0) : m > floor ? m : m != m ? m : floor;
  }
};

// The number of stored values of a kind whose predicates store `n` for the bounded rungs. If these rungs do without
// fma, as many for the plain rungs follow, which use it.
constexpr int stored_count(int n) {
  return MEETC_FUSES ? n : 2 * n;
}

// The signs that the true value can have if v is within `error` of it: all three if v is NaN or infinite. A value can
// overflow although its bound does not, if the compiler contracts one of the two programs and not the other.
template <class V, class E> MEETC_HD MEETC_INLINE sign_set within(const V &v, const E &error) {
  const auto x = leading(v), size = magnitude_of(x);
  const bool known = (size > error) & (size <= largest_finite(x));
  return {static_cast<std::uint8_t>(!known ? 7 : x > 0 ? 4 : 1)};
}

// Whether each sign of the stage, from s on, is known.
template <class Stage> MEETC_HD inline bool all_known(const sign_set *s) {
  int unsure = 0;
  for (int i = 0; i < Stage::atoms; ++i)
    unsure |= s[i].bits == 7;
  return !unsure;
}

// Marks all signs of the stage as unknown, and returns false.
template <class Stage> MEETC_HD inline bool nothing_known(sign_set *all) {
  for (int i = 0; i < Stage::atoms; ++i)
    all[Stage::first + i] = sign_set::all();
  return false;
}

// The bits of P::coincident(): the points of the pair that are equal. Few pairs need them, so they stay out of line.
template <class P> MEETC_NOINLINE MEETC_HD inline std::uint32_t equal_points(const float *row_a, const float *row_b) {
  return computes_as_bounded() ? P::coincident(row_a, row_b) : 0;
}
// Equal points make some polynomials vanish. Their signs are zero, which no bound can tell from a small number. Returns
// whether every sign of the stage is known.
template <class P, class Stage> MEETC_HD inline bool zero_by_equal_points(std::uint32_t equal, sign_set *all) {
  sign_set *s = all + Stage::first;
  for (int i = 0; i < Stage::atoms; ++i)
    if (Stage::zero_if(i) & equal)
      s[i] = sign_set::of(sign::zero);
  return all_known<Stage>(s);
}

// The magnitudes of a stage's values, including those of one object.
template <class Stage, class M, class Leaf>
MEETC_HD MEETC_INLINE void stage_magnitudes(const M *a, const M *b, const Leaf &leaf, M *m) {
  M of_a[Stage::magnitudes_of_a + 1], of_b[Stage::magnitudes_of_b + 1];
  of_a[Stage::magnitudes_of_a] = of_b[Stage::magnitudes_of_b] = M(0); // the spare elements
  if constexpr (Stage::magnitudes_of_a > 0)
    Stage::magnitudes_a(a, leaf, of_a);
  if constexpr (Stage::magnitudes_of_b > 0)
    Stage::magnitudes_b(b, leaf, of_b);
  Stage::magnitudes(a, of_a, b, of_b, leaf, m);
}

// Signs under the bound K M of arithmetic A. by_bounds() takes them from the bound alone, and get() also from equal
// points. Both say whether every sign of the stage is known.
template <class P, class A> struct bounded_signs {
  using V = typename A::value;
  using M = typename A::magnitude;
  using R = typename A::real;
  const float *row_a, *row_b;
  MEETC_HD bounded_signs(const float *a, const float *b) : row_a(a), row_b(b) {}
  MEETC_HD std::uint32_t equal() const { return equal_points<P>(row_a, row_b); }

  template <class Stage> MEETC_HD MEETC_INLINE bool get(sign_set *all) const {
    return by_bounds<Stage>(all) || zero_by_equal_points<P, Stage>(equal(), all);
  }
  template <class Stage> MEETC_HD MEETC_INLINE bool by_bounds(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    V v[Stage::atoms];
    M m[Stage::atoms];
    compute<Stage>(v, m);
    return sort_out<Stage>(v, m, all) || zero_by_grid<Stage>(v, m, all);
  }

  // The stage's values v and their magnitudes m.
  template <class Stage> MEETC_HD MEETC_INLINE void compute(V *v, M *m) const {
    const rows_in<P, V> rows(row_a, row_b);
    stage_values<Stage>(rows.a, rows.b, v);
    constexpr R floor = power_of_two(A::template floor<Stage>(), R(0));
    const leaf_magnitude<M> leaf{M(floor)};
    if constexpr (std::is_same_v<V, M>) {
      stage_magnitudes<Stage>(rows.a, rows.b, leaf, m);
    } else {
      const rows_in<P, M> plain(row_a, row_b);
      stage_magnitudes<Stage>(plain.a, plain.b, leaf, m);
    }
  }
  // The signs of the values by the bound alone. Returns whether all are known.
  template <class Stage> MEETC_HD MEETC_INLINE bool sort_out(const V *v, const M *m, sign_set *all) const {
    sign_set *s = all + Stage::first;
    int unsure = 0;
    for (int i = 0; i < Stage::atoms; ++i) {
      s[i] = m[i] == M(0) ? sign_set::of(sign::zero) : within(v[i], A::template factor<Stage>(i) * R(m[i]));
      unsure |= s[i].bits == 7;
    }
    return !unsure;
  }

  // Finds zeros among the unsure signs by the grid: a homogeneous polynomial of degree k with integer coefficients is a
  // multiple of g^k if its inputs are multiples of g, so a value less than g^k is zero. In fp32 this finds none.
  template <class Stage> MEETC_HD MEETC_INLINE bool zero_by_grid(const V *v, const M *m, sign_set *all) const {
    if constexpr (std::is_same_v<R, float>)
      return false;
    else
      return look_at_grid<Stage>(v, m, all + Stage::first);
  }

private:
  template <class Stage> MEETC_NOINLINE MEETC_HD bool look_at_grid(const V *v, const M *m, sign_set *s) const {
    if (!compiled_as_written())
      return false;
    const pair_grid<P> common = grid_of_pair<P>(row_a, row_b);
    for (int i = 0; i < Stage::atoms; ++i)
      if (s[i].bits == 7 && R(magnitude_of(v[i])) + A::template factor<Stage>(i) * R(m[i]) <
                                std::ldexp(R(0.5), unit_of_sign<Stage>(common, i)))
        s[i] = sign_set::of(sign::zero);
    return all_known<Stage>(s);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
