// Bounds of a stage's values, in powers of the largest difference of a pair's numbers.
//
// Problem: a bound of the error that has a term for each leaf of the program costs as much as the values. Most pairs
// need much less: a bound that is the same for all values of one degree.
// Method: let no difference of two coordinates, and no other number of the pair, exceed D. Then a value of degree n,
// and every value on the way to it, is at most c D^n. Here c is the result of the program if each leaf is 1, or 2 if it
// is a difference of other numbers than coordinates, and each further subtraction adds. The emitted program is run on
// such numbers at compile time. If D is a power of two, c D^n is no less than the floating-point result of the program
// of magnitudes, so a bound that holds for magnitudes holds for it: rounding is monotone, and multiplying by a power of
// two commutes with it.
#ifndef MEETC_DECIDE_UNIT_MAGNITUDES_HPP
#define MEETC_DECIDE_UNIT_MAGNITUDES_HPP

#include <meetc/decide/pair_grid.hpp>
#include <meetc/decide/stages.hpp>

#include <cstdint>
#include <limits>

MEETC_NAMESPACE(meetc) {

// A value's magnitude. An input that is a coordinate has its axis, and has no magnitude except in a difference.
struct unit_magnitude {
  double most = 1;
  int axis = -1;

  constexpr unit_magnitude() = default;
  constexpr explicit unit_magnitude(std::int64_t constant)
      : most(static_cast<double>(constant < 0 ? -constant : constant)) {}
  static constexpr unit_magnitude input(int axis) {
    unit_magnitude m;
    m.axis = axis;
    return m;
  }
  constexpr double size() const { return axis < 0 ? most : std::numeric_limits<double>::infinity(); }
  static constexpr unit_magnitude of(double size) {
    unit_magnitude m;
    m.most = size;
    return m;
  }
  friend constexpr unit_magnitude operator-(unit_magnitude a) { return of(a.size()); }
  friend constexpr unit_magnitude operator+(unit_magnitude a, unit_magnitude b) { return of(a.size() + b.size()); }
  friend constexpr unit_magnitude operator-(unit_magnitude a, unit_magnitude b) {
    return a.axis >= 0 && a.axis == b.axis ? unit_magnitude() : of(a.size() + b.size());
  }
  friend constexpr unit_magnitude operator*(unit_magnitude a, unit_magnitude b) { return of(a.size() * b.size()); }
};

// The magnitudes of a stage's values, infinite if a coordinate occurs outside of a difference.
template <class P, class Stage> struct unit_magnitudes {
  double of[Stage::atoms] = {};
  double most = 0;

  constexpr unit_magnitudes() {
    unit_magnitude a[P::inputs_a], b[P::inputs_b], v[Stage::atoms];
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = unit_magnitude::input(P::axis(i));
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = unit_magnitude::input(P::axis(P::inputs_a + i));
    stage_values<Stage>(a, b, v);
    for (int i = 0; i < Stage::atoms; ++i) {
      of[i] = v[i].size();
      most = most < of[i] ? of[i] : most;
    }
  }
  // Whether they are known, and are numbers in float32. Values of numbers with groups have no one degree.
  constexpr bool usable() const { return !grouped<P> && most <= 0x1p24; }
  // The largest k such that all are at most 2^limit for D = 2^k.
  constexpr int highest_power(int limit) const {
    int k = 0;
    for (double size = most; size > 1; size *= 0.5)
      --limit;
    while ((k + 1) * Stage::degree <= limit)
      ++k;
    return k;
  }
  // The largest whole D for which all are below 2^limit, if one is.
  constexpr double highest(int limit) const {
    if (grouped<P>)
      return 0;
    const auto fits = [&](double d) {
      double size = most;
      for (int k = 0; k < Stage::degree; ++k)
        size *= d;
      for (int k = 0; k < limit; ++k)
        size *= 0.5;
      return size < 1;
    };
    double d = 0;
    for (double step = 0x1p52; step >= 1; step *= 0.5)
      if (fits(d + step))
        d += step;
    return d;
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
