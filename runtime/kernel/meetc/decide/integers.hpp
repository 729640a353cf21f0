// The signs of a stage by integers of 64 or 128 bits, for numbers that are multiples of one power of two.
#ifndef MEETC_DECIDE_INTEGERS_HPP
#define MEETC_DECIDE_INTEGERS_HPP

#include <meetc/decide/pair_grid.hpp>
#include <meetc/decide/stages.hpp>

#include <utility>

MEETC_NAMESPACE(meetc) {

// Calls f<axis>(number) for each number of the pair; the axis is -1 for a number that belongs to none.
template <class P, class F> MEETC_HD MEETC_INLINE void each_input(const float *row_a, const float *row_b, F &&f) {
  // In the order of the list. A fold over the comma is limited to 256 numbers by clang.
  const auto of_a = [&]<int... I>(std::integer_sequence<int, I...>) {
    [[maybe_unused]] const bool called[] = {(f.template operator()<P::axis(I)>(row_a[I]), true)...};
  };
  const auto of_b = [&]<int... I>(std::integer_sequence<int, I...>) {
    [[maybe_unused]] const bool called[] = {(f.template operator()<P::axis(P::inputs_a + I)>(row_b[I]), true)...};
  };
  of_a(std::make_integer_sequence<int, P::inputs_a>());
  of_b(std::make_integer_sequence<int, P::inputs_b>());
}

// The signs of a stage for rows of multiples of 2^low, or of each number's unit: values up to degree 2 in I, the others in W.
// The caller's proof says that they fit. Numbers that occur in differences alone are taken from the first one of their axis, so
// that they are as short as the differences.
template <class P, class Stage, class I, class W, class Units>
MEETC_HD void integer_stage_signs(const float *row_a, const float *row_b, const Units &units, sign *s) {
  I numbers[P::inputs_a + P::inputs_b], origin[3] = {0, 0, 0}, *next = numbers;
  bool seen[3] = {false, false, false};
  each_input<P>(row_a, row_b, [&]<int Axis>(float v) {
    const int i = static_cast<int>(next - numbers);
    I &out = *next++;
    to_integer(as_read<P>(v, i), unit_of(units, i), out);
    if constexpr (Axis >= 0 && Axis <= 2) {
      if (!seen[Axis])
        origin[Axis] = out;
      seen[Axis] = true;
      out -= origin[Axis];
    }
  });
  const I *const ia = numbers, *const ib = numbers + P::inputs_a;
  stage_signs<Stage, I, W>(ia, ib, s);
}

} // MEETC_NAMESPACE(meetc)

#endif
