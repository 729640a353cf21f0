// One error bound for all values of a degree, found without the compiler's bounds, so that the rung exact can judge
// those.
//
// Problem: values that carry their own errors (tracked.hpp) cost several times as much as values alone, and most pairs
// need much less.
// Method: let M be the value of the program on magnitudes. A value that passes through n roundings on its longest way
// is off by at most (1 + 2^-53)^n - 1, which is below n 2^-52, times M, and M is at most c D^degree
// (unit_magnitudes.hpp), where D is a power of two above all differences of the pair's numbers. Running the emitted
// program at compile time gives n and c. A rounding counts as 2^-51, so that those of the bound itself, of which there
// are few, do not matter.
// Limits: doubles that hold floats, and degrees up to 6, for which nothing underflows (tracked.hpp says why).
#ifndef MEETC_DECIDE_COUNTED_ROUNDINGS_HPP
#define MEETC_DECIDE_COUNTED_ROUNDINGS_HPP

#include <meetc/decide/bounds.hpp>
#include <meetc/decide/stages.hpp>

#include <cstdint>

MEETC_NAMESPACE(meetc) {

// The roundings on the longest way to a value.
struct rounding_count {
  int n = 0;

  constexpr rounding_count() = default;
  constexpr explicit rounding_count(std::int64_t) {}
  static constexpr rounding_count of(int n) {
    rounding_count r;
    r.n = n;
    return r;
  }
  friend constexpr rounding_count operator-(rounding_count a) { return a; }
  friend constexpr rounding_count operator+(rounding_count a, rounding_count b) {
    return of((a.n < b.n ? b.n : a.n) + 1);
  }
  friend constexpr rounding_count operator-(rounding_count a, rounding_count b) { return a + b; }
  friend constexpr rounding_count operator*(rounding_count a, rounding_count b) { return of(a.n + b.n + 1); }
};

template <class P, class Stage> struct rounding_counts {
  int of[Stage::atoms] = {};

  constexpr rounding_counts() {
    rounding_count a[P::inputs_a], b[P::inputs_b], v[Stage::atoms];
    stage_values<Stage>(a, b, v);
    for (int i = 0; i < Stage::atoms; ++i)
      of[i] = v[i].n;
  }
};

// The arithmetic that power_errors() takes for this bound. Tests count a rounding as less.
template <class P, int Rounding = -51> struct counted_roundings {
  using real = double;
  template <class Stage> static constexpr int floor() { return -149; }
  template <class Stage> static MEETC_INLINE double factor(int i) {
    static_assert(Stage::degree <= 6);
    static constexpr rounding_counts<P, Stage> counts;
    return counts.of[i] * power_of_two(Rounding, 0.0);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
