// What lanes prove by one comparison at the end: a value beyond 1 proves a positive sign, one below -1 a negative sign.
//
// Problem: a decision over sets of signs compares each value twice, and combines the results as masks of bits.
// Method: where all values have the same unit, of which 1 is more than any error, `and` is the smaller value, `or` the
// larger one, and one comparison with 1 tells where the decision is proved. Only what is proved true is followed: nothing
// is known of a negation. No value is NaN. Users include lanes.hpp.
#ifndef MEETC_LANE_MARGINS_HPP
#define MEETC_LANE_MARGINS_HPP

#include <meetc/float_lanes.hpp>

MEETC_NAMESPACE(meetc) {

// Of a value v, or -v where it is turned; nothing is known of it where it is not `known`. Both are constants once inlined.
struct margin {
  lanes v;
  bool known, turned;

  static MEETC_INLINE margin none() { return {lanes(0.0F), false, false}; }
  MEETC_INLINE lanes value() const { return turned ? -v : v; }
};
// The same of a truth: it is proved where its value exceeds 1.
struct truth_margin {
  margin m;
};

MEETC_INLINE margin operator-(margin a) {
  return {a.v, a.known, !a.turned};
}
MEETC_INLINE lanes with_sign_of(lanes magnitude, lanes a, lanes b) { // that of a b
  typedef std::int32_t bits __attribute__((vector_size(4 * lane_count)));
  const bits sign = (reinterpret_cast<bits>(a.v) ^ reinterpret_cast<bits>(b.v)) & static_cast<std::int32_t>(0x80000000);
  return lanes(reinterpret_cast<lanes::vector>(reinterpret_cast<bits>(magnitude.v) | sign));
}
MEETC_INLINE margin operator*(margin a, margin b) {
  if (!a.known || !b.known)
    return margin::none();
  return {with_sign_of(smaller(magnitude_of(a.v), magnitude_of(b.v)), a.v, b.v), true, a.turned != b.turned};
}
MEETC_INLINE margin square(margin a) {
  return {magnitude_of(a.v), a.known, false};
}

template <int Mask> MEETC_INLINE truth_margin in(margin s) {
  constexpr int signs = Mask & 5; // zero is never proved
  if constexpr (signs == 4)
    return {s};
  else if constexpr (signs == 1)
    return {-s};
  else if constexpr (signs == 5)
    return {square(s)};
  else
    return {margin::none()};
}
MEETC_INLINE truth_margin both(truth_margin a, truth_margin b) {
  const margin x = a.m, y = b.m;
  if (!x.known || !y.known)
    return {margin::none()};
  if (x.turned && y.turned)
    return {{larger(x.v, y.v), true, true}};
  return {{smaller(x.value(), y.value()), true, false}};
}
MEETC_INLINE truth_margin either(truth_margin a, truth_margin b) {
  const margin x = a.m, y = b.m;
  if (!x.known)
    return b;
  if (!y.known)
    return a;
  if (x.turned && y.turned)
    return {{smaller(x.v, y.v), true, true}};
  return {{larger(x.value(), y.value()), true, false}};
}
MEETC_INLINE truth_margin negate(truth_margin) {
  return {margin::none()};
}
MEETC_INLINE truth_margin to_truth_margin(truth_margin a) {
  return a;
}
MEETC_INLINE truth_margin to_truth_margin(bool a) {
  return {{lanes(a ? 2.0F : -2.0F), true, false}};
}
MEETC_INLINE truth_margin both(truth_margin a, bool b) {
  return both(a, to_truth_margin(b));
}
MEETC_INLINE truth_margin both(bool a, truth_margin b) {
  return both(to_truth_margin(a), b);
}
MEETC_INLINE truth_margin either(truth_margin a, bool b) {
  return either(a, to_truth_margin(b));
}
MEETC_INLINE truth_margin either(bool a, truth_margin b) {
  return either(to_truth_margin(a), b);
}

// The lanes in which it is proved.
MEETC_INLINE lane_mask proved(truth_margin a) {
  return a.m.known ? greater(a.m.value(), lanes(1.0F)) : 0;
}

} // MEETC_NAMESPACE(meetc)

#endif
