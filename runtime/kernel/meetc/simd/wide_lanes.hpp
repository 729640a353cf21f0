// Several doubles as one number, and several integers modulo 2^64, on which emitted code runs unchanged: half as many as
// the floats of float_lanes.hpp, whose masks serve here too. The masks' bits from wide_count on have no meaning. Users
// include lanes.hpp.
#ifndef MEETC_SIMD_WIDE_LANES_HPP
#define MEETC_SIMD_WIDE_LANES_HPP

#include <meetc/simd/float_lanes.hpp>

MEETC_NAMESPACE(meetc) {

inline constexpr int wide_count = lane_count / 2;
typedef std::int64_t wide_bits __attribute__((vector_size(8 * wide_count)));

// ---- doubles ----

struct wide_lanes {
  typedef double vector __attribute__((vector_size(8 * wide_count)));
  vector v;

  wide_lanes() = default;
  MEETC_INLINE explicit wide_lanes(vector x) : v(x) {}
  MEETC_INLINE explicit wide_lanes(double x) : v(vector{} + x) {}
  template <class Integer>
  requires std::is_integral_v<Integer> MEETC_INLINE explicit wide_lanes(Integer x)
      : wide_lanes(static_cast<double>(x)) {}
  MEETC_INLINE static wide_lanes from(const float *p) { // of wide_count floats
    typedef float half __attribute__((vector_size(4 * wide_count)));
    half h;
    __builtin_memcpy(&h, p, sizeof h);
    return wide_lanes(__builtin_convertvector(h, vector));
  }
};
MEETC_INLINE wide_lanes operator-(wide_lanes a) {
  return wide_lanes(-a.v);
}
MEETC_INLINE wide_lanes operator+(wide_lanes a, wide_lanes b) {
  return wide_lanes(a.v + b.v);
}
MEETC_INLINE wide_lanes operator-(wide_lanes a, wide_lanes b) {
  return wide_lanes(a.v - b.v);
}
MEETC_INLINE wide_lanes operator*(wide_lanes a, wide_lanes b) {
  return wide_lanes(a.v * b.v);
}
MEETC_INLINE wide_lanes operator/(wide_lanes a, wide_lanes b) { // of constants
  return wide_lanes(a.v / b.v);
}
// One rounding if certified rungs use the instruction; otherwise a product and a sum, as unfused<double>.
MEETC_INLINE wide_lanes fma(wide_lanes a, wide_lanes b, wide_lanes c) {
#if defined(__AVX512F__)
  return wide_lanes(_mm512_fmadd_pd(a.v, b.v, c.v));
#elif defined(__AVX2__) && defined(__FMA__)
  return wide_lanes(_mm256_fmadd_pd(a.v, b.v, c.v));
#elif defined(__FMA__)
  return wide_lanes(_mm_fmadd_pd(a.v, b.v, c.v));
#elif defined(__aarch64__)
  return wide_lanes(vfmaq_f64(c.v, a.v, b.v));
#elif MEETC_FUSES
  wide_lanes r;
  for (int k = 0; k < wide_count; ++k)
    r.v[k] = fma(a.v[k], b.v[k], c.v[k]);
  return r;
#else
  return a * b + c;
#endif
}
MEETC_INLINE wide_lanes multiply_add(wide_lanes a, wide_lanes b, wide_lanes c) { // in formulas
  return fma(a, b, c);
}

// The lanes in which the highest bit is set.
MEETC_INLINE lane_mask highest_bits(wide_bits m) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m));
#elif defined(__AVX512F__)
  return _mm512_cmplt_epi64_mask(reinterpret_cast<__m512i>(m), __m512i{});
#elif defined(__AVX2__)
  return static_cast<lane_mask>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m)));
#elif defined(__SSE2__)
  return static_cast<lane_mask>(_mm_movemask_pd(reinterpret_cast<__m128d>(m)));
#else
  lane_mask bits = 0;
  for (int k = 0; k < wide_count; ++k)
    bits |= static_cast<lane_mask>(m[k] < 0) << k;
  return bits;
#endif
}
// The lanes in which a comparison holds; it does not hold for NaN.
#if defined(__AVX512F__)
MEETC_INLINE lane_mask greater(wide_lanes a, wide_lanes b) {
  return _mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ);
}
MEETC_INLINE lane_mask operator==(wide_lanes a, wide_lanes b) {
  return _mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ);
}
#else
MEETC_INLINE lane_mask greater(wide_lanes a, wide_lanes b) {
  return highest_bits(reinterpret_cast<wide_bits>(a.v > b.v));
}
MEETC_INLINE lane_mask operator==(wide_lanes a, wide_lanes b) {
  return highest_bits(reinterpret_cast<wide_bits>(a.v == b.v));
}
#endif

MEETC_INLINE wide_bits bits_of(wide_lanes a) {
  return reinterpret_cast<wide_bits>(a.v);
}
MEETC_INLINE wide_lanes with_bits(wide_bits b) {
  return wide_lanes(reinterpret_cast<wide_lanes::vector>(b));
}
MEETC_INLINE wide_lanes magnitude_of(wide_lanes a) {
  return with_bits(bits_of(a) & 0x7fffffffffffffff);
}
// The larger one, or b if one of them is NaN.
MEETC_INLINE wide_lanes larger(wide_lanes a, wide_lanes b) {
#if defined(__AVX512F__)
  return wide_lanes(_mm512_maskz_max_pd(0xff, a.v, b.v));
#elif defined(__AVX2__)
  return wide_lanes(_mm256_max_pd(a.v, b.v));
#elif defined(__SSE2__)
  return wide_lanes(_mm_max_pd(a.v, b.v));
#else
  return wide_lanes(a.v > b.v ? a.v : b.v);
#endif
}
// The smaller one, likewise.
MEETC_INLINE wide_lanes smaller(wide_lanes a, wide_lanes b) {
#if defined(__AVX512F__)
  return wide_lanes(_mm512_maskz_min_pd(0xff, a.v, b.v));
#elif defined(__AVX2__)
  return wide_lanes(_mm256_min_pd(a.v, b.v));
#elif defined(__SSE2__)
  return wide_lanes(_mm_min_pd(a.v, b.v));
#else
  return wide_lanes(a.v < b.v ? a.v : b.v);
#endif
}
// The largest power of two that is not above a, for normal a > 0; 0 for smaller ones, and infinity for itself.
MEETC_INLINE wide_lanes power_below(wide_lanes a) {
  return with_bits(bits_of(a) & 0x7ff0000000000000);
}

// The signs of eight doubles in v[0], v[stride], … Each is zero or at least 2^-1022. A zero of either sign counts as
// zero, and may count as negative too.
inline constexpr int vectors_of_eight = 8 / wide_count;
struct eight_signs {
  lane_mask negative, zero;
};
MEETC_INLINE eight_signs signs_of_eight(const wide_lanes *v, std::ptrdiff_t stride) {
#if defined(__SSE2__) && !defined(__AVX2__)
  // By the upper halves of the numbers, of which only zeros have no bits but the sign.
  const auto upper = [&](std::ptrdiff_t k) {
    const auto a = reinterpret_cast<__m128>(v[k * stride].v), b = reinterpret_cast<__m128>(v[(k + 1) * stride].v);
    return _mm_castps_si128(_mm_shuffle_ps(a, b, 0xdd));
  };
  const __m128i first = upper(0), second = upper(2);
  const __m128i sizes = _mm_packs_epi32(_mm_add_epi32(first, first), _mm_add_epi32(second, second));
  const int bits =
      _mm_movemask_epi8(_mm_packs_epi16(_mm_packs_epi32(first, second), _mm_cmpeq_epi16(sizes, _mm_setzero_si128())));
  return {static_cast<lane_mask>(bits & 0xff), static_cast<lane_mask>(bits >> 8)};
#else
  constexpr lane_mask every = all_bits >> (32 - wide_count);
  eight_signs s{0, 0};
  for (int k = 0; k < vectors_of_eight; ++k) {
    s.negative |= (highest_bits(bits_of(v[k * stride])) & every) << k * wide_count;
    s.zero |= ((v[k * stride] == wide_lanes(0.0)) & every) << k * wide_count;
  }
  return s;
#endif
}

// ---- integers modulo 2^64 ----

struct whole_lanes {
  typedef std::uint64_t vector __attribute__((vector_size(8 * wide_count)));
  vector v;

  whole_lanes() = default;
  MEETC_INLINE explicit whole_lanes(vector x) : v(x) {}
  MEETC_INLINE explicit whole_lanes(std::int64_t x) : v(vector{} + static_cast<std::uint64_t>(x)) {}
};
MEETC_INLINE whole_lanes operator-(whole_lanes a) {
  return whole_lanes(-a.v);
}
MEETC_INLINE whole_lanes operator+(whole_lanes a, whole_lanes b) {
  return whole_lanes(a.v + b.v);
}
MEETC_INLINE whole_lanes operator-(whole_lanes a, whole_lanes b) {
  return whole_lanes(a.v - b.v);
}
MEETC_INLINE whole_lanes operator*(whole_lanes a, whole_lanes b) {
  return whole_lanes(a.v * b.v);
}
MEETC_INLINE lane_mask negative(whole_lanes a) {
  return highest_bits(reinterpret_cast<wide_bits>(a.v));
}
MEETC_INLINE lane_mask zero(whole_lanes a) {
#if defined(__AVX512F__)
  return _mm512_testn_epi64_mask(reinterpret_cast<__m512i>(a.v), reinterpret_cast<__m512i>(a.v));
#else
  return highest_bits(reinterpret_cast<wide_bits>(a.v == whole_lanes::vector{}));
#endif
}

} // MEETC_NAMESPACE(meetc)

#endif
