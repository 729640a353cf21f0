// Numbers that carry a bound of their own error: running error analysis.
//
// Problem: the exact rung needs signs that do not depend on the bounds of the other rungs.
// Method: every operation adds its largest rounding error to the errors of its operands. V is lanes of double; tests use
// double.
// Source: Wilkinson; Higham, "Accuracy and Stability of Numerical Algorithms", 3.3.
#ifndef MEETC_SIMD_TRACKED_HPP
#define MEETC_SIMD_TRACKED_HPP

#include <meetc/decide/bounds.hpp>
#include <meetc/simd/wide_lanes.hpp>

#include <type_traits>

MEETC_NAMESPACE(meetc) {

// v is within e of the true value, while no NaN occurs. A rounding counts as 2^-51 of the result, four times that to
// the nearest, so that neither contraction to fma nor the roundings of e itself matter, of which there are far fewer
// than 2^40. Nothing underflows: values are products of at most highest_degree differences of floats, each 0 or at
// least 2^-149, so that no value but 0 is below 2^-894, no error but 0 below 2^-52 of it, and no product of two errors
// below 2^-998.
template <class V, int Rounding = -51> struct tracked_number { // tests use other roundings
  static constexpr int highest_degree = 6;
  V v = V(0.0), e = V(0.0);

  tracked_number() = default;
  MEETC_INLINE explicit tracked_number(V exact) : v(exact) {}
  // A constant of a program; none is beyond 2^53.
  template <class Integer>
  requires std::is_integral_v<Integer> MEETC_INLINE explicit tracked_number(Integer exact)
      : v(static_cast<double>(exact)) {}
};
template <int Rounding, class V> MEETC_INLINE tracked_number<V, Rounding> rounded(V v, V e) {
  constexpr double rounding = power_of_two(Rounding, 0.0);
  tracked_number<V, Rounding> r(v);
  r.e = multiply_add<V>(V(rounding), magnitude_of(v), e);
  return r;
}
template <class V, int R> MEETC_INLINE tracked_number<V, R> operator-(tracked_number<V, R> a) {
  a.v = -a.v;
  return a;
}
template <class V, int R> MEETC_INLINE tracked_number<V, R> operator+(tracked_number<V, R> a, tracked_number<V, R> b) {
  return rounded<R>(a.v + b.v, a.e + b.e);
}
template <class V, int R> MEETC_INLINE tracked_number<V, R> operator-(tracked_number<V, R> a, tracked_number<V, R> b) {
  return rounded<R>(a.v - b.v, a.e + b.e);
}
template <class V, int R> MEETC_INLINE tracked_number<V, R> operator*(tracked_number<V, R> a, tracked_number<V, R> b) {
  return rounded<R>(a.v * b.v, multiply_add<V>(magnitude_of(a.v) + a.e, b.e, a.e * magnitude_of(b.v)));
}

} // MEETC_NAMESPACE(meetc)

#endif
