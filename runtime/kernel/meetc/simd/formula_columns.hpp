// A formula on columns, in lanes. Emitted sources include this before any header of formulas, as lanes.hpp asks.
//
// A formula F has `operands`, `numbers` and `results`, the operand of each number as operand_of(k), and
// values(const T *in, T *out) on one row of numbers.
#ifndef MEETC_SIMD_FORMULA_COLUMNS_HPP
#define MEETC_SIMD_FORMULA_COLUMNS_HPP

#include <meetc/simd/lanes.hpp>

#include <meetc/table/formula_table.hpp>
#include <meetc/table/table_entry.hpp>

MEETC_NAMESPACE(meetc) {

template <class Number> struct lanes_of;
template <> struct lanes_of<float> {
  using type = lanes;
  static constexpr int count = lane_count;
};
template <> struct lanes_of<double> {
  using type = wide_lanes;
  static constexpr int count = wide_count;
};

// `count` evaluations from `first` on, at most as many as there are lanes; the other lanes repeat the last one.
template <class F, class Number>
MEETC_INLINE void gathered_lanes(const column *in, const std::uint32_t *rows, std::size_t first, int count,
                                 typename lanes_of<Number>::type *row) {
  constexpr int L = lanes_of<Number>::count;
  std::size_t which[F::operands][L];
  for (int l = 0; l < L; ++l) {
    const std::size_t i = first + static_cast<std::size_t>(l < count ? l : count - 1);
    for (int k = 0; k < F::operands; ++k)
      which[k][l] = rows ? rows[i * F::operands + static_cast<std::size_t>(k)] : i;
  }
  for (int k = 0; k < F::numbers; ++k) {
    float values[L];
    const std::size_t *const at = which[F::operand_of(k)];
    for (int l = 0; l < L; ++l)
      values[l] = in[k].data[static_cast<std::ptrdiff_t>(at[l]) * in[k].stride];
    row[k] = lanes_of<Number>::type::from(values);
  }
}

template <class F, class Number>
void evaluate_columns(const column *in, const std::uint32_t *rows, std::size_t n, Number *const *out) {
  using lane = typename lanes_of<Number>::type;
  constexpr int L = lanes_of<Number>::count;
  bool packed = rows == nullptr; // each column is contiguous, or one number
  for (int k = 0; k < F::numbers; ++k)
    packed = packed && (in[k].stride == 1 || in[k].stride == 0);
  lane row[F::numbers], value[F::results];
  for (std::size_t i = 0; i < n; i += L) {
    const int count = n - i < static_cast<std::size_t>(L) ? static_cast<int>(n - i) : L;
    if (packed && count == L)
      for (int k = 0; k < F::numbers; ++k)
        row[k] = in[k].stride ? lane::from(in[k].data + i) : lane(static_cast<Number>(*in[k].data));
    else
      gathered_lanes<F, Number>(in, rows, i, count, row);
    F::values(row, value);
    if (count == L)
      for (int k = 0; k < F::results; ++k)
        __builtin_memcpy(out[k] + i, &value[k].v, sizeof value[k].v);
    else
      for (int k = 0; k < F::results; ++k)
        __builtin_memcpy(out[k] + i, &value[k].v, static_cast<std::size_t>(count) * sizeof(Number));
  }
}

template <class F> formula_info formula_of(const char *name, const formula_operand *operands, const char *results) {
  return {name,
          operands,
          F::operands,
          results,
          F::results,
          F::numbers,
          guarded<evaluate_columns<F, float>>,
          guarded<evaluate_columns<F, double>>};
}

} // MEETC_NAMESPACE(meetc)

#endif
