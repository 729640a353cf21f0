// One bound for all values of a degree, from a power of two above the differences of a pair's numbers, in lanes.
//
// unit_magnitudes.hpp has the proof. It costs a few operations, where a bound of each value by the magnitudes of its leaves
// costs as much as the values, and it is larger by a factor of some ten. What it proves, the other proves too.
// Users include lanes.hpp.
#ifndef MEETC_POWER_BOUND_HPP
#define MEETC_POWER_BOUND_HPP

#include <meetc/bounds.hpp>
#include <meetc/float_lanes.hpp>
#include <meetc/lane_signs.hpp>
#include <meetc/unit_magnitudes.hpp>
#include <meetc/wide_lanes.hpp>

MEETC_NAMESPACE(meetc) {

// By lane, the largest difference of two coordinates on one axis and the largest magnitude of another number, but at least
// 2^-149, and the largest magnitude of all numbers. The difference is rounded, as those are that a program computes.
template <class L> struct lane_extent { L largest, numbers; };
template <class P, class L> MEETC_INLINE lane_extent<L> extent_of(const L *a, const L *b) {
  lane_extent<L> e{L(0x1p-149F), L(0x1p-149F)};
  L low[3], high[3];
  bool seen[3] = {false, false, false};
  const auto take = [&](L x, int axis) {
    if (axis < 0)
      e.largest = larger(magnitude_of(x), e.largest);
    else if (!seen[axis])
      low[axis] = high[axis] = x, seen[axis] = true;
    else
      low[axis] = smaller(x, low[axis]), high[axis] = larger(x, high[axis]);
  };
  for (int i = 0; i < P::inputs_a; ++i)
    take(a[i], P::axis(i));
  for (int i = 0; i < P::inputs_b; ++i)
    take(b[i], P::axis(P::inputs_a + i));
  e.numbers = e.largest;
  for (int k = 0; k < 3; ++k)
    if (seen[k]) {
      e.largest = larger(high[k] - low[k], e.largest);
      e.numbers = larger(larger(magnitude_of(low[k]), magnitude_of(high[k])), e.numbers);
    }
  return e;
}

// Whether the bound is of use for a stage.
template <class P, class Stage> constexpr bool has_power_bound() {
  if constexpr (Stage::atoms > 0)
    return unit_magnitudes<P, Stage>().usable();
  return true;
}

// The errors of a stage's values in arithmetic A. Returns the lanes in which they, and the values, are finite.
template <class P, class Stage, class A, class L>
MEETC_INLINE lane_mask power_errors(const lane_extent<L> &e, L *error) {
  using real = typename A::real;
  static constexpr unit_magnitudes<P, Stage> unit;
  constexpr real floor = power_of_two(A::template floor<Stage>(), real(0));
  L powers[Stage::degree + 1];
  powers[1] = larger(L(real(2)) * power_below(e.largest), L(floor));
  for (int k = 1; k < Stage::degree; ++k)
    powers[k + 1] = powers[k] * powers[1];
  for (int i = 0; i < Stage::atoms; ++i)
    error[i] = L(A::template factor<Stage>(i)) * (L(static_cast<real>(unit.of[i])) * powers[Stage::degree_of(i)]);
  // Up to this power magnitudes are finite, and values are no larger.
  constexpr int highest = unit.highest_power(std::numeric_limits<real>::max_exponent - 2);
  if constexpr (highest < 129)
    return ~greater(powers[1], L(1 / power_of_two(-highest, real(0))));
  return all_bits;
}
// What they prove of the signs of the values v. Of zeros they prove nothing.
template <class P, class Stage, class A, class L>
MEETC_INLINE void signs_by_power(const L *v, const lane_extent<L> &e, proved_lanes *s) {
  L error[Stage::atoms];
  const lane_mask finite = power_errors<P, Stage, A>(e, error), sound = computes_as_bounded() ? finite : 0;
  for (int i = 0; i < Stage::atoms; ++i)
    s[i] = {greater(-v[i], error[i]) & sound, 0, greater(v[i], error[i]) & sound};
}

} // MEETC_NAMESPACE(meetc)

#endif
