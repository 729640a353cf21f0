// The rungs of a predicate: how its stages' values become signs, or sets of signs, and those an answer.
//
// A predicate P has stages (reject, common, rare; absent ones are no_stage), each a program from stored numbers to
// values: object_a and object_b compute what one object alone decides, pair the rest. P::rejected, P::usual,
// P::needs_rare and P::whole are its decision, for sign and for sign_set alike. Signs are numbered over all stages;
// a stage's own begin at Stage::first.
#ifndef MEETC_RUNGS_HPP
#define MEETC_RUNGS_HPP

#include <meetc/double_double.hpp>
#include <meetc/integers.hpp>
#include <meetc/valid.hpp>

#include <cmath>

namespace meetc {

struct no_stage {
  static constexpr int atoms = 0, first = 0;
};

// The stage's values for rows of T; those of degree 3 and more in W.
template <class Stage, class T, class W> MEETC_HD MEETC_INLINE void stage_values(const T *a, const T *b, W *v) {
  T fields_a[Stage::fields_a + 1], fields_b[Stage::fields_b + 1];
  fields_a[Stage::fields_a] = fields_b[Stage::fields_b] = T(0); // the spare places, for stages that store nothing
  Stage::object_a(a, fields_a);
  Stage::object_b(b, fields_b);
  Stage::template pair<T, W>(a, fields_a, b, fields_b, v);
}

template <class Stage, class T, class W = T> MEETC_HD MEETC_INLINE void stage_signs(const T *a, const T *b, sign *s) {
  W v[Stage::atoms];
  stage_values<Stage>(a, b, v);
  for (int i = 0; i < Stage::atoms; ++i)
    s[Stage::first + i] = sign_of(v[i]);
}

// The rows of a pair in another number type.
template <class P, class T> struct rows_in {
  T a[P::inputs_a], b[P::inputs_b];
  MEETC_HD MEETC_INLINE rows_in(const float *row_a, const float *row_b) {
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = static_cast<T>(row_a[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = static_cast<T>(row_b[i]);
  }
};

// ---- plain ----

// A plain rung takes the sign of the computed value and says nothing about how wrong it can be.
template <class P, class T> struct plain_signs {
  rows_in<P, T> rows;
  MEETC_HD plain_signs(const float *row_a, const float *row_b) : rows(row_a, row_b) {}
  template <class Stage> MEETC_HD void get(sign *s) const { stage_signs<Stage>(rows.a, rows.b, s); }
};

// ---- with a bound ----

// K with |computed - true| <= K M for a value and its magnitude M, by arithmetic.
struct factors {
  float fp32;
  double fp64, fp64x2;
};
// The bound c alpha^a beta^b D^pair of a value in fp32, inside a box.
struct box_factor {
  float c;
  signed char a, b, pair;
};

// The three arithmetics with bounds.
struct in_fp32 {
  using value = float;
  using magnitude = float;
  MEETC_HD static constexpr float factor(const factors &k) { return k.fp32; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp32; }
};
struct in_fp64 {
  using value = double;
  using magnitude = double;
  MEETC_HD static constexpr double factor(const factors &k) { return k.fp64; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp64; }
};
struct in_fp64x2 {
  using value = double_double;
  using magnitude = double;
  MEETC_HD static constexpr double factor(const factors &k) { return k.fp64x2; }
  template <class Stage> MEETC_HD static constexpr int floor() { return Stage::floor_fp64; }
};

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

// The signs that v can have when it is within `error` of the truth. NaN: any. A value that is not finite: any, since what
// overflowed on the way to it need not have overflowed on the way to its bound, where a compiler has contracted one of the
// two programs and not the other.
template <class V, class E> MEETC_HD MEETC_INLINE sign_set within(const V &v, const E &error) {
  const auto x = leading(v), size = magnitude_of(x);
  const bool known = (size > error) & (size <= largest_finite(x));
  return {static_cast<std::uint8_t>(!known ? 7 : x > 0 ? 4 : 1)};
}

template <class Stage> MEETC_HD inline bool all_known(const sign_set *s) {
  int unsure = 0;
  for (int i = 0; i < Stage::atoms; ++i)
    unsure |= s[i].bits == 7;
  return !unsure;
}

// No sign of the stage is known; false.
template <class Stage> MEETC_HD inline bool nothing_known(sign_set *all) {
  for (int i = 0; i < Stage::atoms; ++i)
    all[Stage::first + i] = sign_set::all();
  return false;
}

// Equal points make some polynomials vanish: their signs are zero, which no bound can tell from small numbers.
template <class P, class Stage>
MEETC_HD inline void zero_by_equal_points(const float *row_a, const float *row_b, sign_set *s) {
  if constexpr (P::coincidences > 0) {
    const std::uint32_t equal = P::coincident(row_a, row_b);
    for (int i = 0; i < Stage::atoms; ++i)
      if (Stage::zero_if(i) & equal)
        s[i] = sign_set::of(sign::zero);
  }
}

// Signs with the bound K M of arithmetic A. get() says whether every sign of the stage is known.
template <class P, class A> struct bounded_signs {
  using V = typename A::value;
  using M = typename A::magnitude;
  const float *row_a, *row_b;
  MEETC_HD bounded_signs(const float *a, const float *b) : row_a(a), row_b(b) {}

  template <class Stage> MEETC_HD MEETC_INLINE bool get(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    const rows_in<P, V> rows(row_a, row_b);
    V v[Stage::atoms];
    stage_values<Stage>(rows.a, rows.b, v);
    M m[Stage::atoms];
    const leaf_magnitude<M> leaf{power_of_two(A::template floor<Stage>(), M(0))};
    if constexpr (std::is_same_v<V, M>) {
      Stage::magnitudes(rows.a, rows.b, leaf, m);
    } else {
      const rows_in<P, M> plain(row_a, row_b);
      Stage::magnitudes(plain.a, plain.b, leaf, m);
    }
    sign_set *s = all + Stage::first;
    int unsure = 0;
    for (int i = 0; i < Stage::atoms; ++i) {
      s[i] = m[i] == M(0) ? sign_set::of(sign::zero) : within(v[i], A::factor(Stage::factor(i)) * m[i]);
      unsure |= s[i].bits == 7;
    }
    if constexpr (P::coincidences > 0 || !std::is_same_v<M, float>)
      return !unsure || settle<Stage>(v, m, s);
    else
      return !unsure;
  }

private:
  // Zeros by equal points, and by the grid: a homogeneous polynomial of degree k with integer coefficients is a
  // multiple of g^k where its inputs are multiples of g, so what is less than g^k is zero.
  template <class Stage> MEETC_NOINLINE MEETC_HD bool settle(const V *v, const M *m, sign_set *s) const {
    zero_by_equal_points<P, Stage>(row_a, row_b, s);
    if (!compiled_as_written())
      return all_known<Stage>(s);
    if constexpr (!std::is_same_v<M, float>) {
      const int low = join(grid_of(row_a, P::inputs_a), grid_of(row_b, P::inputs_b)).low;
      for (int i = 0; i < Stage::atoms; ++i)
        if (s[i].bits == 7 &&
            magnitude_of(v[i]) + A::factor(Stage::factor(i)) * m[i] < std::ldexp(M(0.5), low * Stage::degree_of(i)))
          s[i] = sign_set::of(sign::zero);
    }
    return all_known<Stage>(s);
  }
};

// The larger of m and |x|; NaN when x is.
MEETC_HD MEETC_INLINE float larger(float m, float x) {
  const float a = magnitude_of(x);
  return a <= m ? m : a;
}

// The least power of two that is not below x >= 0; infinite and NaN stay.
MEETC_HD inline float power_above(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  if (b < 0x7f800000 && (b & 0x7fffff))
    b = (b & 0x7f800000) + 0x800000;
  std::memcpy(&x, &b, sizeof b);
  return x;
}

// The least power of two that is above x >= 0; infinite and NaN stay.
MEETC_HD inline float power_over(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  if (b < 0x7f800000)
    b = (b & 0x7f800000) + 0x800000;
  std::memcpy(&x, &b, sizeof b);
  return x;
}

enum class box_form : std::uint8_t { per_object, whole_box };

// Signs in fp32 inside a box of side D, a power of two: every difference of two coordinates, every length and every
// coordinate that stands alone (P::axis) is at most D, exactly. per_object also takes the objects' own extents, found
// anew for each pair; whole_box ("static") takes D for them. Stage::box_lowest <= log2 D <= Stage::box_highest must
// hold for every stage: see box_holds().
template <class P, box_form F> struct boxed_signs {
  rows_in<P, float> rows;
  float d;
  MEETC_HD boxed_signs(const float *a, const float *b, float side) : rows(a, b), d(side) {}

  template <class Stage> MEETC_HD bool get(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    float v[Stage::atoms];
    stage_values<Stage>(rows.a, rows.b, v);
    float alpha = d, beta = d;
    if constexpr (F == box_form::per_object) {
      const float least = power_of_two(Stage::box_lowest, 0.0F);
      // Over the computed leaves, not at them: a difference of a little more than a power of two is rounded to it.
      alpha = power_over(Stage::extent_a(rows.a)), beta = power_over(Stage::extent_b(rows.b));
      alpha = alpha < least ? least : alpha > d ? d : alpha, beta = beta < least ? least : beta > d ? d : beta;
    }
    sign_set *s = all + Stage::first;
    int unsure = 0;
    for (int i = 0; i < Stage::atoms; ++i) {
      const box_factor f = Stage::box(i);
      s[i] = within(v[i], f.c * power(alpha, f.a) * power(beta, f.b) * power(d, f.pair));
      unsure |= s[i].bits == 7;
    }
    if constexpr (P::coincidences > 0)
      if (unsure) {
        zero_by_equal_points<P, Stage>(rows.a, rows.b, s);
        return all_known<Stage>(s);
      }
    return !unsure;
  }

private:
  MEETC_HD MEETC_INLINE static constexpr float power(float x, int n) {
    float r = 1;
    for (int i = 0; i < n; ++i)
      r *= x;
    return r;
  }
};

// Whether the box form covers a box of this side.
template <class P> MEETC_HD inline bool box_holds(float side) {
  const auto holds = [side](auto stage) {
    using Stage = decltype(stage);
    if constexpr (Stage::atoms == 0)
      return true;
    else
      return side >= power_of_two(Stage::box_lowest, 0.0F) && side <= 1 / power_of_two(-Stage::box_highest, 0.0F) &&
             power_above(side) == side;
  };
  return holds(typename P::reject_stage()) && holds(typename P::common_stage()) && holds(typename P::rare_stage());
}

MEETC_HD inline bool is_known(sign_set s) {
  return s.bits == 1 || s.bits == 2 || s.bits == 4;
}
// The sign of a set of one.
MEETC_HD inline sign known_sign(sign_set s) {
  return static_cast<sign>((s.bits >> 2) - (s.bits & 1));
}

// Sets of one sign each as those signs.
template <class Stage> MEETC_HD inline void known_signs(const sign_set *sets, sign *s) {
  for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
    s[i] = known_sign(sets[i]);
}

// ---- exact ----

MEETC_HD inline grid join(grid x, grid y) {
  return {x.low < y.low ? x.low : y.low, x.high > y.high ? x.high : y.high};
}

// Integers on the grid of the pair's own numbers, as wide as the stage needs. Depends on nothing: neither on compiler
// flags nor on the control word.
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
    // Finite numbers span 277 bits, 2^-149 to 2^128; the bits of infinity and NaN are read as numbers below 2^129.
    constexpr int most = (Stage::degree * 278 + Stage::growth) / 64 + 1;
    std::uint64_t place[Stage::places][most];
    const int limbs = need / 64 + 1; // and a bit for the sign
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_a; ++i)
      to_limbs(a[i], common.low, limbs, place[i]);
    MEETC_ROLLED
    for (int i = 0; i < P::inputs_b; ++i)
      to_limbs(b[i], common.low, limbs, place[P::inputs_a + i]);
    MEETC_ROLLED
    for (int i = 0; i < Stage::step_count; ++i)
      take_step<most>(Stage::step_at(i), limbs, place, s + Stage::first);
  }
};

// The exact rung. Where the differences are short on their common grid, values up to degree 2 are exact in fp64 and
// the rest in double-double, without a branch; elsewhere double-double with its bound; what is left, in integers. Where the
// environment is not the standard one, in integers alone.
template <class P> struct exact_signs {
  const float *a, *b;
  grid common;
  bool standard;
  int bits; // of the differences, on the grid; where `standard`
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
        const rows_in<P, double> rows(a, b);
        if constexpr (Stage::mixed)
          stage_signs<Stage, double, double_double>(rows.a, rows.b, s);
        else
          stage_signs<Stage, double>(rows.a, rows.b, s);
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
  // axis no difference exceeds the largest number less the least; numbers of no axis count twice, since they may
  // stand in differences with each other. -1000: all of them are zero.
  MEETC_HD static int spread(const float *row_a, const float *row_b) {
    double low[4] = {0, 0, 0, 0}, high[4] = {0, 0, 0, 0};
    bool seen[4] = {false, false, false, false};
    const auto take = [&](double v, int axis) {
      const int k = axis < 0 || axis > 2 ? 3 : axis;
      if (k == 3) // as a range from -2 |v| to 0
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

// ---- decisions ----

// Runs the stages in order and stops at the first that decides.
template <class P, class Signs> MEETC_HD inline bool decide(const Signs &signs) {
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

// The same on sets of signs: the answer that every choice of signs from the sets gives, or unsure. A reject stage
// that is unsure is no reason to stop, since the decision is right without it. While every sign is known the logic
// of signs is taken, which is several times faster than that of sets.
template <class P, class Signs> MEETC_HD MEETC_INLINE answer decide_sets(const Signs &signs) {
  sign_set sets[P::atoms + 1];
  sign s[P::atoms + 1];
  bool known = true;
  if constexpr (P::reject_stage::atoms > 0) {
    known = signs.template get<typename P::reject_stage>(sets);
    if (known) {
      known_signs<typename P::reject_stage>(sets, s);
      if (P::rejected(s))
        return answer::no;
    } else if (!can_be_false(P::rejected(sets))) {
      return answer::no;
    }
  }
  if constexpr (P::common_stage::atoms > 0) {
    known = signs.template get<typename P::common_stage>(sets) && known;
    if (known)
      known_signs<typename P::common_stage>(sets, s);
  }
  if constexpr (P::rare_stage::atoms > 0) {
    const truth rare = known ? to_truth(P::needs_rare(s)) : to_truth(P::needs_rare(sets));
    if (can_be_true(rare)) {
      if (can_be_false(rare)) { // perhaps: the next rung will know
        for (int i = 0; i < P::rare_stage::atoms; ++i)
          sets[P::rare_stage::first + i] = sign_set::all();
        known = false;
      } else {
        known = signs.template get<typename P::rare_stage>(sets) && known;
        if (known)
          known_signs<typename P::rare_stage>(sets, s);
      }
      return known ? to_answer(P::whole(s)) : to_answer(P::whole(sets));
    }
  }
  return known ? to_answer(P::usual(s)) : to_answer(P::usual(sets));
}

// One rung of `certified` where the environment is known to be the standard one: no and yes are proved.
template <class P, class A> MEETC_HD MEETC_INLINE answer certify_here(const float *row_a, const float *row_b) {
  return decide_sets<P>(bounded_signs<P, A>(row_a, row_b));
}
// The same anywhere: unsure in any other environment.
template <class P, class A> MEETC_HD inline answer certify(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return answer::unsure;
  return before_return(certify_here<P, A>(after_check(row_a), after_check(row_b)));
}

// The rungs of `certified` after fp32, in the standard environment. What few pairs need stays out of line.
template <class P> MEETC_NOINLINE MEETC_HD inline bool decide_after_fp32(const float *row_a, const float *row_b) {
  const answer x = certify_here<P, in_fp64>(row_a, row_b);
  return x == answer::unsure ? decide<P>(exact_signs<P>(row_a, row_b)) : x == answer::yes;
}
// All rungs of `certified` for one pair: never wrong, for any valid operands, in any environment.
template <class P> MEETC_HD inline bool decide_certified(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide<P>(integer_signs<P>(row_a, row_b));
  row_a = after_check(row_a), row_b = after_check(row_b);
  const answer x = certify_here<P, in_fp32>(row_a, row_b);
  return before_return(x == answer::unsure ? decide_after_fp32<P>(row_a, row_b) : x == answer::yes);
}

// One sign, for kernels that are nothing else.
template <class P, class Signs> MEETC_HD inline sign decide_sign(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  return P::value(s);
}
template <class P, class A> MEETC_HD MEETC_INLINE sign_set certify_sign_here(const float *row_a, const float *row_b) {
  sign_set s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    bounded_signs<P, A>(row_a, row_b).template get<typename P::common_stage>(s);
  return P::value(s);
}
template <class P, class A> MEETC_HD inline sign_set certify_sign(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return sign_set::all();
  return sign_set{before_return(certify_sign_here<P, A>(after_check(row_a), after_check(row_b)).bits)};
}
template <class P> MEETC_HD inline sign decide_certified_sign(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide_sign<P>(integer_signs<P>(row_a, row_b));
  row_a = after_check(row_a), row_b = after_check(row_b);
  const sign_set s = certify_sign_here<P, in_fp32>(row_a, row_b);
  return before_return(is_known(s) ? known_sign(s) : decide_sign<P>(exact_signs<P>(row_a, row_b)));
}

// ---- for operands as they are stored ----
//
// What emitted entry points call. to_row() is the operands' own. It reads them after the check, and once more for what
// few pairs need, so that the rows of the others can stay in registers.

template <class P, class A, class B> struct rows_of {
  float a[P::inputs_a], b[P::inputs_b];
  MEETC_HD MEETC_INLINE rows_of(const A &x, const B &y) { to_row(x, a), to_row(y, b); }
};
// f(row_a, row_b) of rows that are read here, out of line.
template <class P, class A, class B, class F>
MEETC_NOINLINE MEETC_HD inline auto rarely(const A &x, const B &y, F &&f) {
  const rows_of<P, A, B> rows(x, y);
  return f(rows.a, rows.b);
}

template <class P, class A, class B> MEETC_HD inline bool hit_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, [](const float *a, const float *b) { return decide<P>(integer_signs<P>(a, b)); });
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const answer by_fp32 = certify_here<P, in_fp32>(rows.a, rows.b);
  if (by_fp32 != answer::unsure)
    return before_return(by_fp32 == answer::yes);
  return before_return(rarely<P>(*after_check(&p), *after_check(&q),
                                 [](const float *a, const float *b) { return decide_after_fp32<P>(a, b); }));
}
template <class P, class A, class B> MEETC_HD inline bool hit_exact(const A &x, const B &y) {
  return before_return(rarely<P>(x, y, [](const float *a, const float *b) { return decide<P>(exact_signs<P>(a, b)); }));
}
template <class P, class A, class B> MEETC_HD inline answer filter_fp32(const A &x, const B &y) {
  if (!standard_environment())
    return answer::unsure;
  const rows_of<P, A, B> rows(*after_check(&x), *after_check(&y));
  return before_return(certify_here<P, in_fp32>(rows.a, rows.b));
}
template <class P, class A, class B> MEETC_HD inline sign sign_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, [](const float *a, const float *b) { return decide_sign<P>(integer_signs<P>(a, b)); });
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const sign_set by_fp32 = certify_sign_here<P, in_fp32>(rows.a, rows.b);
  if (is_known(by_fp32))
    return before_return(known_sign(by_fp32));
  return before_return(rarely<P>(*after_check(&p), *after_check(&q),
                                 [](const float *a, const float *b) { return decide_sign<P>(exact_signs<P>(a, b)); }));
}
template <class P, class A, class B> MEETC_HD inline sign sign_exact(const A &x, const B &y) {
  return before_return(
      rarely<P>(x, y, [](const float *a, const float *b) { return decide_sign<P>(exact_signs<P>(a, b)); }));
}

} // namespace meetc

#endif
