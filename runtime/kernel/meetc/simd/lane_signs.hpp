// Sets of signs of many values at a time, as bit masks: a set of signs of all lanes is three masks, so the
// logic of a decision costs as much for all lanes as for one pair. Users include lanes.hpp.
#ifndef MEETC_SIMD_LANE_SIGNS_HPP
#define MEETC_SIMD_LANE_SIGNS_HPP

#include <meetc/simd/float_lanes.hpp>

MEETC_NAMESPACE(meetc) {

// Decisions may be made for more pairs than the lanes hold: for as many as a mask has bits.
inline constexpr lane_mask all_bits = ~lane_mask{0};

// The signs that each lane can have.
struct sign_lanes {
  lane_mask negative, zero, positive;
  MEETC_INLINE static sign_lanes of(sign s) {
    return {s == sign::negative ? all_bits : 0, s == sign::zero ? all_bits : 0, s == sign::positive ? all_bits : 0};
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

// For lanes of floats and of doubles alike.

// The magnitude of a leaf, as leaf_magnitude has it.
template <class L> MEETC_INLINE L leaf_at_least(L difference, L floor) {
  const L m = magnitude_of(difference), zero(0.0F);
  L r;
  r.v = ((m.v > floor.v) | (m.v != m.v)) ? m.v : floor.v;
  r.v = m.v == zero.v ? zero.v : r.v;
  return r;
}

// The lanes in which a sign is proved to be negative, zero or positive.
struct proved_lanes {
  lane_mask negative, zero, positive;
};
// The proved signs of values within `error` of v; a magnitude of zero proves zero, and NaN proves nothing. v must be finite
// where it exceeds its error.
template <class L> MEETC_INLINE proved_lanes proved(L v, L error, L magnitude) {
  return {greater(-v, error), magnitude == L(0.0F), greater(v, error)};
}
MEETC_INLINE sign_lanes possible(proved_lanes p) {
  return {~(p.zero | p.positive), ~(p.negative | p.positive), ~(p.negative | p.zero)};
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
  return {a ? 0 : all_bits, a ? all_bits : 0};
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
