// Several floats as one number, on which emitted code runs unchanged, and what is known of their signs as bit masks.
//
// The vectors are those of the compiler (gcc's vector_size, which clang has too), as wide as the instruction set's
// registers. The standard library's experimental simd would do as well but for fma(), which gcc 12 compiles to a call
// with its operands in memory, and generated code depends on no other library. A set of signs of all lanes is three
// masks, so the logic of a decision costs as much for all lanes as for one pair.
//
// Include this before any header of generated predicates: these call meetc::both() and its like with qualified names,
// which find only what is declared before them.
#ifndef MEETC_LANES_HPP
#define MEETC_LANES_HPP

#include <meetc/double_double.hpp>

#if defined(__AVX512F__) || defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

MEETC_NAMESPACE(meetc) {

// ---- numbers ----

#if defined(__AVX512F__)
inline constexpr int lane_count = 16;
#elif defined(__AVX2__)
inline constexpr int lane_count = 8;
#else
inline constexpr int lane_count = 4;
#endif
using lane_mask = std::uint32_t; // bit k: lane k
inline constexpr lane_mask every_lane = (lane_mask{1} << lane_count) - 1;

struct lanes {
  typedef float vector __attribute__((vector_size(4 * lane_count)));
  vector v;

  lanes() = default;
  MEETC_INLINE explicit lanes(vector x) : v(x) {}
  MEETC_INLINE explicit lanes(float x) : v(vector{} + x) {}
  MEETC_INLINE static lanes from(const float *p) { // of lane_count floats
    lanes r;
    __builtin_memcpy(&r.v, p, sizeof r.v);
    return r;
  }
};
MEETC_INLINE lanes operator-(lanes a) {
  return lanes(-a.v);
}
MEETC_INLINE lanes operator+(lanes a, lanes b) {
  return lanes(a.v + b.v);
}
MEETC_INLINE lanes operator-(lanes a, lanes b) {
  return lanes(a.v - b.v);
}
MEETC_INLINE lanes operator*(lanes a, lanes b) {
  return lanes(a.v * b.v);
}
// One rounding where certified rungs use the instruction; otherwise a product and a sum, as unfused<float>.
MEETC_INLINE lanes fma(lanes a, lanes b, lanes c) {
#if defined(__AVX512F__)
  return lanes(_mm512_fmadd_ps(a.v, b.v, c.v));
#elif defined(__AVX2__) && defined(__FMA__)
  return lanes(_mm256_fmadd_ps(a.v, b.v, c.v));
#elif defined(__FMA__)
  return lanes(_mm_fmadd_ps(a.v, b.v, c.v));
#elif defined(__aarch64__)
  return lanes(vfmaq_f32(c.v, a.v, b.v));
#elif MEETC_FUSES
  lanes r;
  for (int k = 0; k < lane_count; ++k)
    r.v[k] = fma(a.v[k], b.v[k], c.v[k]);
  return r;
#else
  return a * b + c;
#endif
}

// The lanes in which a comparison holds. It holds in none where an operand is NaN.
#if defined(__AVX512F__)
MEETC_INLINE lane_mask greater(lanes a, lanes b) {
  return _mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ);
}
MEETC_INLINE lane_mask equal(lanes a, lanes b) {
  return _mm512_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ);
}
#else
MEETC_INLINE lane_mask to_mask(decltype(lanes::vector{} > lanes::vector{}) m) {
#if defined(__AVX2__)
  return static_cast<lane_mask>(_mm256_movemask_ps(reinterpret_cast<__m256>(m)));
#elif defined(__SSE2__)
  return static_cast<lane_mask>(_mm_movemask_ps(reinterpret_cast<__m128>(m)));
#else
  lane_mask bits = 0;
  for (int k = 0; k < lane_count; ++k)
    bits |= static_cast<lane_mask>(m[k] & 1) << k;
  return bits;
#endif
}
MEETC_INLINE lane_mask greater(lanes a, lanes b) {
  return to_mask(a.v > b.v);
}
MEETC_INLINE lane_mask equal(lanes a, lanes b) {
  return to_mask(a.v == b.v);
}
#endif

MEETC_INLINE lanes magnitude_of(lanes a) {
  typedef std::int32_t bits __attribute__((vector_size(4 * lane_count)));
  return lanes(reinterpret_cast<lanes::vector>(reinterpret_cast<bits>(a.v) & 0x7fffffff));
}

// ---- signs ----

// The signs that each lane can have.
struct sign_lanes {
  lane_mask negative, zero, positive;
  MEETC_INLINE static sign_lanes of(sign s) {
    return {s == sign::negative ? every_lane : 0, s == sign::zero ? every_lane : 0,
            s == sign::positive ? every_lane : 0};
  }
};
MEETC_INLINE sign_lanes operator-(sign_lanes s) {
  return {s.positive, s.zero, s.negative};
}
MEETC_INLINE sign_lanes operator*(sign_lanes a, sign_lanes b) {
  return {(a.negative & b.positive) | (a.positive & b.negative), a.zero | b.zero,
          (a.negative & b.negative) | (a.positive & b.positive)};
}
MEETC_INLINE sign_lanes square(sign_lanes s) {
  return {0, s.zero, s.negative | s.positive};
}

// Three-valued truths by lane.
struct truth_lanes {
  lane_mask can_be_false, can_be_true;
};
template <int Mask> MEETC_INLINE truth_lanes in(sign_lanes s) {
  const auto any = [&s](int mask) {
    return (mask & 1 ? s.negative : 0) | (mask & 2 ? s.zero : 0) | (mask & 4 ? s.positive : 0);
  };
  return {any(~Mask), any(Mask)};
}
MEETC_INLINE truth_lanes to_truth_lanes(truth_lanes a) {
  return a;
}
MEETC_INLINE truth_lanes to_truth_lanes(bool a) {
  return {a ? 0 : every_lane, a ? every_lane : 0};
}
MEETC_INLINE truth_lanes both(truth_lanes a, truth_lanes b) {
  return {a.can_be_false | b.can_be_false, a.can_be_true & b.can_be_true};
}
MEETC_INLINE truth_lanes either(truth_lanes a, truth_lanes b) {
  return {a.can_be_false & b.can_be_false, a.can_be_true | b.can_be_true};
}
MEETC_INLINE truth_lanes negate(truth_lanes a) {
  return {a.can_be_true, a.can_be_false};
}
MEETC_INLINE truth_lanes both(truth_lanes a, bool b) {
  return both(a, to_truth_lanes(b));
}
MEETC_INLINE truth_lanes both(bool a, truth_lanes b) {
  return both(to_truth_lanes(a), b);
}
MEETC_INLINE truth_lanes either(truth_lanes a, bool b) {
  return either(a, to_truth_lanes(b));
}
MEETC_INLINE truth_lanes either(bool a, truth_lanes b) {
  return either(to_truth_lanes(a), b);
}

} // MEETC_NAMESPACE(meetc)

#endif
