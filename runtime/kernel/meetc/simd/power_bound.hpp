// One bound for all values of a degree, from a power of two above the differences of a pair's numbers, in lanes.
//
// unit_magnitudes.hpp has the proof. This bound costs a few operations; a bound of each value by the magnitudes of its
// leaves costs as much as the values. It is larger by a factor of some ten, so every sign that it proves the other
// proves too. Users include lanes.hpp.
#ifndef MEETC_SIMD_POWER_BOUND_HPP
#define MEETC_SIMD_POWER_BOUND_HPP

#include <meetc/decide/bounds.hpp>
#include <meetc/decide/unit_magnitudes.hpp>
#include <meetc/simd/float_lanes.hpp>
#include <meetc/simd/lane_signs.hpp>
#include <meetc/simd/wide_lanes.hpp>

MEETC_NAMESPACE(meetc) {

// By lane, the largest difference of two coordinates on one axis, or the largest magnitude of another number if that is
// more. The difference is rounded, like those in the program.
template <class P, class L> MEETC_INLINE L extent_of(const L *a, const L *b) {
  L largest(0.0F), low[3], high[3];
  bool seen[3] = {false, false, false};
  const auto take = [&](L x, int axis) {
    if (axis < 0)
      largest = larger(magnitude_of(x), largest);
    else if (!seen[axis])
      low[axis] = high[axis] = x, seen[axis] = true;
    else
      low[axis] = smaller(x, low[axis]), high[axis] = larger(x, high[axis]);
  };
  for (int i = 0; i < P::inputs_a; ++i)
    take(a[i], P::axis(i));
  for (int i = 0; i < P::inputs_b; ++i)
    take(b[i], P::axis(P::inputs_a + i));
  for (int k = 0; k < 3; ++k)
    if (seen[k])
      largest = larger(high[k] - low[k], largest);
  return largest;
}

// Whether the bound is of use for a stage.
template <class P, class Stage> constexpr bool has_power_bound() {
  if constexpr (Stage::atoms > 0)
    return unit_magnitudes<P, Stage>().usable();
  return true;
}

// The errors of a stage's values in arithmetic A, from the extent of the pair.
template <class P, class Stage, class A, class L> MEETC_INLINE void power_errors(L extent, L *error) {
  using real = typename A::real;
  static constexpr unit_magnitudes<P, Stage> unit;
  constexpr real floor = power_of_two(A::template floor<Stage>(), real(0));
  L powers[Stage::degree + 1];
  powers[1] = larger(L(real(2)) * power_below(extent), L(floor));
  for (int k = 1; k < Stage::degree; ++k)
    powers[k + 1] = powers[k] * powers[1];
  for (int i = 0; i < Stage::atoms; ++i)
    error[i] = L(A::template factor<Stage>(i)) * (L(static_cast<real>(unit.of[i])) * powers[Stage::degree_of(i)]);
}
// The signs of the values v that these errors prove. They prove no zeros.
template <class P, class Stage, class A, class L>
MEETC_INLINE void signs_by_power(const L *v, L extent, proved_lanes *s) {
  using real = typename A::real;
  L error[Stage::atoms];
  power_errors<P, Stage, A>(extent, error);
  lane_mask sound = computes_as_bounded() ? all_bits : 0;
  // Values are no larger than magnitudes. If one value of the stage can overflow, nothing is proved of the others
  // either, as with the bound by leaves.
  constexpr int highest = unit_magnitudes<P, Stage>().highest_power(std::numeric_limits<real>::max_exponent - 2);
  if constexpr (highest < 129) // no float is beyond 2^128
    sound &= ~greater(L(real(2)) * power_below(extent), L(1 / power_of_two(-highest, real(0))));
  for (int i = 0; i < Stage::atoms; ++i)
    s[i] = {greater(-v[i], error[i]) & sound, 0, greater(v[i], error[i]) & sound};
}

} // MEETC_NAMESPACE(meetc)

#endif
