// Numbers of about 106 bits as unevaluated sums of two doubles, |lo| <= ulp(hi)/2.
//
// Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM
// TOMS 44(2), 2017: sums are within 3 u^2 / (1 - 4u) of the true result, products within 6 u^2 with fma and within 7 u^2
// without (algorithms 11 and 10), products with a double within 2 u^2 and 3/2 u^2 + 4 u^3 (9 and 7), u = 2^-53. All
// operations here are therefore within 2^-102, with room for underflow as long as products stay above 2^-960.
//
// All functions are inlined, since a copy in another translation unit may have been compiled with another fma().
#ifndef MEETC_NUMBER_DOUBLE_DOUBLE_HPP
#define MEETC_NUMBER_DOUBLE_DOUBLE_HPP

#include <meetc/number/formula.hpp>
#include <meetc/number/logic.hpp>

MEETC_NAMESPACE(meetc) {

// `Fused`: products use the fused multiply-add. Plain rungs always do, so that they answer alike everywhere.
template <bool Fused> struct double_words {
  double hi, lo;
  double_words() = default;
  MEETC_HD explicit double_words(double h) : hi(h), lo(0) {}
  MEETC_HD double_words(double h, double l) : hi(h), lo(l) {}
};
using double_double = double_words<true>;

// ---- error-free transforms: exact unless they overflow (or two_product underflows), for any compiler flags ----

// hi + lo = a + b.
template <bool Fused = true> MEETC_HD MEETC_INLINE double_words<Fused> two_sum(double a, double b) {
#if defined(__CUDA_ARCH__)
  const double s = __dadd_rn(a, b), t = __dsub_rn(s, a);
  return {s, __dadd_rn(__dsub_rn(a, __dsub_rn(s, t)), __dsub_rn(b, t))};
#else
  a = opaque(a), b = opaque(b); // an incoming product must not be contracted with the sum
  const double s = opaque(a + b), t = opaque(s - a), rest = opaque(s - t), x = opaque(a - rest), y = opaque(b - t);
  return {s, x + y};
#endif
}

// The same for |a| >= |b| or a = 0.
template <bool Fused = true> MEETC_HD MEETC_INLINE double_words<Fused> fast_two_sum(double a, double b) {
#if defined(__CUDA_ARCH__)
  const double s = __dadd_rn(a, b);
  return {s, __dsub_rn(b, __dsub_rn(s, a))};
#else
  const double s = opaque(a + b), t = opaque(s - a);
  return {s, b - t};
#endif
}

// hi + lo = a b. Without the fused multiply-add: Veltkamp's splitting and Dekker's product (Dekker, "A floating-point
// technique for extending the available precision", Numerische Mathematik 18, 1971), which is exact for |a|, |b| <=
// 2^995 where |a b| <= 2^1021 and either a b = 0 or |a b| >= 2^-969; tests/proofs/coq/dekker.v proves it. Every product
// that a rung forms is of multiples of 2^-149 and, up to degree 6, below 2^800.
template <bool Fused = true> MEETC_HD MEETC_INLINE double_words<Fused> two_product(double a, double b) {
#if defined(__CUDA_ARCH__)
  const double p = __dmul_rn(a, b);
  return {p, __fma_rn(a, b, -p)};
#else
  const double p = opaque(a * b);
  if constexpr (Fused) {
    return {p, __builtin_fma(a, b, -p)};
  } else {
    const double splitter = 0x1p27 + 1, x = opaque(a * splitter), y = opaque(b * splitter);
    const double ah = opaque(opaque(a - x) + x), al = opaque(a - ah);
    const double bh = opaque(opaque(b - y) + y), bl = opaque(b - bh);
    const double rest = opaque(opaque(ah * bh) - p);
    return {p, opaque(opaque(rest + opaque(ah * bl)) + opaque(al * bh)) + opaque(al * bl)};
  }
#endif
}

// ---- arithmetic ----

template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator-(const double_words<F> &x) {
  return {-x.hi, -x.lo};
}

template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator+(const double_words<F> &x, const double_words<F> &y) {
  const double_words<F> s = two_sum<F>(x.hi, y.hi), t = two_sum<F>(x.lo, y.lo);
  const double_words<F> v = fast_two_sum<F>(s.hi, opaque(s.lo + t.hi));
  return fast_two_sum<F>(v.hi, opaque(t.lo + v.lo));
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator+(const double_words<F> &x, double y) {
  const double_words<F> s = two_sum<F>(x.hi, y);
  return fast_two_sum<F>(s.hi, opaque(x.lo + s.lo));
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator+(double x, const double_words<F> &y) {
  return y + x;
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator-(const double_words<F> &x, const double_words<F> &y) {
  return x + -y;
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator-(const double_words<F> &x, double y) {
  return x + -y;
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator-(double x, const double_words<F> &y) {
  return -y + x;
}

template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator*(const double_words<F> &x, const double_words<F> &y) {
  const double_words<F> c = two_product<F>(x.hi, y.hi);
  double low;
  if constexpr (F)
    low = __builtin_fma(x.lo, y.hi, opaque(x.hi * y.lo));
  else
    low = opaque(x.lo * y.hi) + opaque(x.hi * y.lo);
  return fast_two_sum<F>(c.hi, opaque(c.lo + low));
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator*(const double_words<F> &x, double y) {
  const double_words<F> c = two_product<F>(x.hi, y);
  if constexpr (F) {
    return fast_two_sum<F>(c.hi, __builtin_fma(x.lo, y, c.lo));
  } else {
    const double_words<F> t = fast_two_sum<F>(c.hi, opaque(x.lo * y));
    return fast_two_sum<F>(t.hi, opaque(t.lo + c.lo));
  }
}
template <bool F> MEETC_HD MEETC_INLINE double_words<F> operator*(double x, const double_words<F> &y) {
  return y * x;
}

template <bool F> MEETC_HD MEETC_INLINE sign sign_of(const double_words<F> &v) {
  return static_cast<sign>(static_cast<int>(v.hi > 0) - static_cast<int>(v.hi < 0));
}

// ---- numbers without fma ----

// A number on which emitted code runs with a product and a sum for every fma(). Its bounds are Stage::factor_unfused and
// box_unfused.
template <class T> struct unfused {
  T v;
  unfused() = default;
  MEETC_HD MEETC_INLINE explicit unfused(T x) : v(x) {}
  MEETC_HD MEETC_INLINE operator T() const { return v; } // NOLINT: comparisons are those of T
};
template <class T> MEETC_HD MEETC_INLINE unfused<T> operator-(unfused<T> a) {
  return unfused<T>(-a.v);
}
template <class T> MEETC_HD MEETC_INLINE unfused<T> operator+(unfused<T> a, unfused<T> b) {
  return unfused<T>(a.v + b.v);
}
template <class T> MEETC_HD MEETC_INLINE unfused<T> operator-(unfused<T> a, unfused<T> b) {
  return unfused<T>(a.v - b.v);
}
template <class T> MEETC_HD MEETC_INLINE unfused<T> operator*(unfused<T> a, unfused<T> b) {
  return unfused<T>(a.v * b.v);
}
template <class T> MEETC_HD MEETC_INLINE unfused<T> operator/(unfused<T> a, unfused<T> b) { // of constants
  return unfused<T>(a.v / b.v);
}
template <class T> MEETC_HD MEETC_INLINE unfused<T> magnitude_of(unfused<T> a) {
  return unfused<T>(a.v < 0 ? -a.v : a.v);
}
template <class T> MEETC_HD MEETC_INLINE T leading(unfused<T> a) {
  return a.v;
}

// ---- one emitted formula for every number type ----
//
// T holds the values of degree 1 and 2, W those above; they differ only where T is a double and W double_words.

template <class T> MEETC_HD MEETC_INLINE constexpr sign sign_of(const T &v) {
  return static_cast<sign>(static_cast<int>(v > T(0)) - static_cast<int>(v < T(0)));
}

template <class W> inline constexpr bool is_double_words = false;
template <bool F> inline constexpr bool is_double_words<double_words<F>> = true;
template <bool F> MEETC_HD MEETC_INLINE double_words<F> widened_product(double a, double b, const double_words<F> *) {
  return two_product<F>(a, b);
}
template <class W, class A, class B> MEETC_HD MEETC_INLINE constexpr W times(const A &a, const B &b) {
  if constexpr (is_double_words<W> && std::is_convertible_v<A, double> && std::is_convertible_v<B, double>)
    return widened_product(a, b, static_cast<const W *>(nullptr));
  else if constexpr (std::is_same_v<A, std::int64_t> && sizeof(W) > sizeof(A)) // the product of wider integers
    return W(a) * W(b);
  else
    return W(a * b);
}

MEETC_HD MEETC_INLINE float fma(float a, float b, float c) {
  return __builtin_fmaf(a, b, c);
}
MEETC_HD MEETC_INLINE double fma(double a, double b, double c) {
  return __builtin_fma(a, b, c);
}
template <class A, class B, class C> MEETC_HD MEETC_INLINE constexpr C fma(const A &a, const B &b, const C &c) {
  return times<C>(a, b) + c;
}

MEETC_HD MEETC_INLINE float magnitude_of(float v) {
  return __builtin_fabsf(v);
}
MEETC_HD MEETC_INLINE double magnitude_of(double v) {
  return __builtin_fabs(v);
}
// The magnitude of a double-double's high word, which is within 2^-53 of the whole.
template <bool F> MEETC_HD MEETC_INLINE double magnitude_of(const double_words<F> &v) {
  return __builtin_fabs(v.hi);
}
MEETC_HD MEETC_INLINE float leading(float v) {
  return v;
}
MEETC_HD MEETC_INLINE double leading(double v) {
  return v;
}
template <bool F> MEETC_HD MEETC_INLINE double leading(const double_words<F> &v) {
  return v.hi;
}
MEETC_HD MEETC_INLINE float largest_finite(float) {
  return 0x1.fffffep127F;
}
MEETC_HD MEETC_INLINE double largest_finite(double) {
  return 0x1.fffffffffffffp1023;
}

} // MEETC_NAMESPACE(meetc)

#endif
