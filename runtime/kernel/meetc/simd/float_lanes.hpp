// Several floats as one number, on which emitted code runs unchanged, and comparisons of them as bit masks.
//
// The vectors are those of the compiler (gcc's vector_size, which clang has too), as wide as the instruction set's
// registers. The standard library's experimental simd would do as well but for fma(), which gcc 12 compiles to a call
// with its operands in memory, and generated code depends on no other library. Users include lanes.hpp.
#ifndef MEETC_SIMD_FLOAT_LANES_HPP
#define MEETC_SIMD_FLOAT_LANES_HPP

#include <meetc/number/double_double.hpp>

#include <cstddef>
#include <utility>

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
  template <class Integer>
  requires std::is_integral_v<Integer> MEETC_INLINE explicit lanes(Integer x) : lanes(static_cast<float>(x)) {}
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
MEETC_INLINE lanes operator/(lanes a, lanes b) { // of constants
  return lanes(a.v / b.v);
}
// One rounding if certified rungs use the instruction; otherwise a product and a sum, as unfused<float>.
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
MEETC_INLINE lanes multiply_add(lanes a, lanes b, lanes c) { // in formulas
  return fma(a, b, c);
}

// The lanes in which a comparison holds; it does not hold for NaN. Emitted code compares by ==, since a spec may have a
// kind with the name of any function.
#if defined(__AVX512F__)
MEETC_INLINE lane_mask greater(lanes a, lanes b) {
  return _mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ);
}
MEETC_INLINE lane_mask operator==(lanes a, lanes b) {
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
MEETC_INLINE lane_mask operator==(lanes a, lanes b) {
  return to_mask(a.v == b.v);
}
#endif

MEETC_INLINE lanes magnitude_of(lanes a) {
  typedef std::int32_t bits __attribute__((vector_size(4 * lane_count)));
  return lanes(reinterpret_cast<lanes::vector>(reinterpret_cast<bits>(a.v) & 0x7fffffff));
}

// The largest power of two that is not above a, for normal a > 0; 0 for smaller ones, and infinity for itself.
MEETC_INLINE lanes power_below(lanes a) {
  typedef std::int32_t bits __attribute__((vector_size(4 * lane_count)));
  return lanes(reinterpret_cast<lanes::vector>(reinterpret_cast<bits>(a.v) & 0x7f800000));
}

// The larger one, or b if one of them is NaN.
MEETC_INLINE lanes larger(lanes a, lanes b) {
#if defined(__AVX512F__)
  return lanes(_mm512_maskz_max_ps(0xffff, a.v, b.v));
#elif defined(__AVX2__)
  return lanes(_mm256_max_ps(a.v, b.v));
#elif defined(__SSE2__)
  return lanes(_mm_max_ps(a.v, b.v));
#else
  return lanes(a.v > b.v ? a.v : b.v);
#endif
}
// The smaller one, likewise.
MEETC_INLINE lanes smaller(lanes a, lanes b) {
#if defined(__AVX512F__)
  return lanes(_mm512_maskz_min_ps(0xffff, a.v, b.v));
#elif defined(__AVX2__)
  return lanes(_mm256_min_ps(a.v, b.v));
#elif defined(__SSE2__)
  return lanes(_mm_min_ps(a.v, b.v));
#else
  return lanes(a.v < b.v ? a.v : b.v);
#endif
}

// ---- rows by lane ----

#if defined(__SSE2__) || defined(__AVX2__) || defined(__AVX512F__) || defined(__aarch64__)
#define MEETC_TRANSPOSES 1
// For each part of four numbers: interleaves the first two of x and y, or the last two.
#if defined(__AVX512F__)
// The forms with a mask, of every lane: gcc 12 warns of an undefined value within the others.
inline constexpr __mmask16 all_16 = 0xffff;
MEETC_INLINE lanes low_in_turn(lanes x, lanes y) {
  return lanes(_mm512_maskz_unpacklo_ps(all_16, x.v, y.v));
}
MEETC_INLINE lanes high_in_turn(lanes x, lanes y) {
  return lanes(_mm512_maskz_unpackhi_ps(all_16, x.v, y.v));
}
MEETC_INLINE lanes low_halves(lanes x, lanes y) {
  return lanes(_mm512_maskz_shuffle_ps(all_16, x.v, y.v, 0x44));
}
MEETC_INLINE lanes high_halves(lanes x, lanes y) {
  return lanes(_mm512_maskz_shuffle_ps(all_16, x.v, y.v, 0xee));
}
MEETC_INLINE lanes parts(const float *p0, const float *p1, const float *p2, const float *p3) {
  const __m512 first = _mm512_castps128_ps512(_mm_loadu_ps(p0));
  const __m512 half = _mm512_maskz_insertf32x4(all_16, first, _mm_loadu_ps(p1), 1);
  const __m512 more = _mm512_maskz_insertf32x4(all_16, half, _mm_loadu_ps(p2), 2);
  return lanes(_mm512_maskz_insertf32x4(all_16, more, _mm_loadu_ps(p3), 3));
}
#elif defined(__AVX2__)
MEETC_INLINE lanes low_in_turn(lanes x, lanes y) {
  return lanes(_mm256_unpacklo_ps(x.v, y.v));
}
MEETC_INLINE lanes high_in_turn(lanes x, lanes y) {
  return lanes(_mm256_unpackhi_ps(x.v, y.v));
}
MEETC_INLINE lanes low_halves(lanes x, lanes y) {
  return lanes(_mm256_shuffle_ps(x.v, y.v, 0x44));
}
MEETC_INLINE lanes high_halves(lanes x, lanes y) {
  return lanes(_mm256_shuffle_ps(x.v, y.v, 0xee));
}
MEETC_INLINE lanes parts(const float *p0, const float *p1) {
  return lanes(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p0)), _mm_loadu_ps(p1), 1));
}
#elif defined(__SSE2__)
MEETC_INLINE lanes low_in_turn(lanes x, lanes y) {
  return lanes(_mm_unpacklo_ps(x.v, y.v));
}
MEETC_INLINE lanes high_in_turn(lanes x, lanes y) {
  return lanes(_mm_unpackhi_ps(x.v, y.v));
}
MEETC_INLINE lanes low_halves(lanes x, lanes y) {
  return lanes(_mm_shuffle_ps(x.v, y.v, 0x44));
}
MEETC_INLINE lanes high_halves(lanes x, lanes y) {
  return lanes(_mm_shuffle_ps(x.v, y.v, 0xee));
}
MEETC_INLINE lanes parts(const float *p) {
  return lanes(_mm_loadu_ps(p));
}
#else
MEETC_INLINE lanes low_in_turn(lanes x, lanes y) {
  return lanes(vzip1q_f32(x.v, y.v));
}
MEETC_INLINE lanes high_in_turn(lanes x, lanes y) {
  return lanes(vzip2q_f32(x.v, y.v));
}
MEETC_INLINE lanes low_halves(lanes x, lanes y) {
  return lanes(vcombine_f32(vget_low_f32(x.v), vget_low_f32(y.v)));
}
MEETC_INLINE lanes high_halves(lanes x, lanes y) {
  return lanes(vcombine_f32(vget_high_f32(x.v), vget_high_f32(y.v)));
}
MEETC_INLINE lanes parts(const float *p) {
  return lanes(vld1q_f32(p));
}
#endif

// Four numbers of lane_count rows by lane; row k begins at from + at[k] * stride. Blocks of four rows by four numbers are
// transposed, one in each part of the registers.
template <int... Part>
MEETC_INLINE void gather_four(const float *from, std::size_t stride, const std::uint32_t *at, lanes *to,
                              std::integer_sequence<int, Part...>) {
  const auto rows = [&](int k) { return parts(from + at[4 * Part + k] * stride...); };
  const lanes row0 = rows(0), row1 = rows(1), row2 = rows(2), row3 = rows(3);
  const lanes low01 = low_in_turn(row0, row1), low23 = low_in_turn(row2, row3);
  const lanes high01 = high_in_turn(row0, row1), high23 = high_in_turn(row2, row3);
  to[0] = low_halves(low01, low23), to[1] = high_halves(low01, low23);
  to[2] = low_halves(high01, high23), to[3] = high_halves(high01, high23);
}
#else
#define MEETC_TRANSPOSES 0
#endif

// Column i of `to` becomes the number i of each of the lane_count rows of N numbers at from + at[k] * N.
template <int N> MEETC_INLINE void gather_rows(const float *from, const std::uint32_t *at, lanes *to) {
#if MEETC_TRANSPOSES
  if constexpr (N >= 4) {
    // The last four numbers may overlap those before.
    for (int i = 0; i < N; i = i + 4 < N && i + 8 > N ? N - 4 : i + 4)
      gather_four(from + i, N, at, to + i, std::make_integer_sequence<int, lane_count / 4>());
    return;
  }
#endif
  float turned[N][lane_count];
  for (int k = 0; k < lane_count; ++k)
    for (int i = 0; i < N; ++i)
      turned[i][k] = from[std::size_t{at[k]} * N + static_cast<std::size_t>(i)];
  for (int i = 0; i < N; ++i)
    to[i] = lanes::from(turned[i]);
}

} // MEETC_NAMESPACE(meetc)

#endif
