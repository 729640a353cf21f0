// A bilinear form as a product of half-precision matrices, of which only the signs of the results are used.
//
// A form F(X, Y) = sum_k f_k(X) g_k(Y) + f(X) + g(Y) with few products fits into one matrix step. Each factor becomes
// two halves, h + l; the products h h, h l and l h are kept, and an additive term takes two columns next to a constant.
// The losses of this, and those of the unit's own addition, are subtracted from the additive terms as a margin for each
// element. For any two elements inside the frame, therefore,
//   F <= 0 implies that the unit's result is negative,
// if the unit obeys the model: from 16 products t_i, each exact, it computes a sum that is within 17 2^-23 sum |t_i| of
// their sum, in whatever order, with or without truncation and subnormals. No vendor promises that; probe()
// (probe.hpp) can refute it and cannot prove it. Form holds the constants of the margin and says where they come
// from. Source of the splitting: Markidis et al., "NVIDIA Tensor Core Programmability, Performance and Precision",
// 2018.
#ifndef MEETC_EVERY_PAIR_MATRIX_HPP
#define MEETC_EVERY_PAIR_MATRIX_HPP

#include <meetc/every_pair/frame.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>

MEETC_NAMESPACE(meetc) {

inline constexpr int matrix_columns = 16;
// Elements come in tiles of 8, and arrays have room for a whole block behind any of them.
inline constexpr int matrix_block = 512;

// The index of column k of element i, in halves: a tile is two rows of eight 16-byte pieces, as the matrix units read
// it.
MEETC_HD constexpr std::size_t matrix_place(std::size_t i, int k) {
  return i / 8 * 128 + static_cast<std::size_t>(k / 8) * 64 + i % 8 * 8 + static_cast<std::size_t>(k % 8);
}
MEETC_HD constexpr std::size_t matrix_padded(std::size_t elements) {
  return (elements + std::size_t{2} * matrix_block - 1) / matrix_block * matrix_block;
}

// The bits of the half nearest to x, ties to even; 0 below the normal range, 2^-14. |x| <= 65504.
MEETC_HD inline std::uint16_t to_half(double x) {
  std::uint64_t b;
  std::memcpy(&b, &x, sizeof b);
  const auto sign = static_cast<std::uint16_t>(b >> 48 & 0x8000);
  b &= 0x7fffffffffffffff;
  if (b < std::uint64_t{1009} << 52) // 2^-14
    return 0;
  b += ((std::uint64_t{1} << 41) - 1) + (b >> 42 & 1);
  return static_cast<std::uint16_t>(sign | ((b >> 42) - (std::uint64_t{1008} << 10)));
}
// The value of such bits.
MEETC_HD inline double from_half(std::uint16_t h) {
  if ((h & 0x7fff) == 0)
    return 0;
  const std::uint64_t b =
      static_cast<std::uint64_t>(h & 0x8000) << 48 | (static_cast<std::uint64_t>(h & 0x7fff) + (1008 << 10)) << 42;
  double x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}
// The largest half that is not above x, in the normal range or 0. |x| <= 65504.
MEETC_HD inline std::uint16_t to_half_below(double x) {
  const std::uint16_t h = to_half(x);
  if (from_half(h) <= x)
    return h;
  if (h == 0)
    return 0x8400; // -2^-14
  return static_cast<std::uint16_t>(h & 0x8000 ? h + 1 : h == 0x0400 ? 0 : h - 1);
}

inline constexpr double matrix_constant = 256; // the factor of additive columns

// The additive term of an element with features f (Form::products factors, then the term), less its margin.
template <class Form> MEETC_HD inline double with_margin(const double *f) {
  double squares = 0, sizes = 0;
  for (int k = 0; k < Form::products; ++k)
    squares += f[k] * f[k], sizes += std::fabs(f[k]);
  const double term = f[Form::products];
  return term - (Form::margin_square * squares + Form::margin_additive * std::fabs(term) + Form::margin_linear * sizes +
                 Form::margin_absolute);
}

// The only term of an element that is not inside. The form's own additive term of one that is lies between -2.01 2^20
// and 6.01 2^20, since inputs are at most 2^11. The sum of two terms is therefore negative exactly where `placing` says
// that the elements meet, and no rounding can change that.
MEETC_HD constexpr double term_outside(placing where) {
  switch (where) {
  case placing::nowhere:
    return 24 * 0x1p20;
  case placing::apart:
    return 12 * 0x1p20;
  case placing::astride:
    return -8 * 0x1p20;
  default:
    return -16 * 0x1p20; // everywhere
  }
}

// The columns of an element of X (First) or Y, by its ball.
template <class Form, bool First>
MEETC_HD inline void to_columns(const double *ball, placing where, std::uint16_t *out) {
  static_assert(3 * Form::products + 4 <= matrix_columns, "the form needs more columns than one matrix step has");
  static_assert(Form::largest_input == matrix_reach && Form::additive_unit == matrix_constant,
                "the form's margins are proved for another scaling");
  for (int k = 0; k < matrix_columns; ++k)
    out[k] = 0;
  constexpr int own = 3 * Form::products + (First ? 0 : 2), other = 3 * Form::products + (First ? 2 : 0);
  out[other] = out[other + 1] = to_half(matrix_constant);
  if (where != placing::inside) {
    out[own] = out[own + 1] = to_half(term_outside(where) / (2 * matrix_constant));
    return;
  }
  double f[Form::products + 1];
  if constexpr (First)
    Form::features_a(ball, f);
  else
    Form::features_b(ball, f);
  for (int k = 0; k < Form::products; ++k) {
    const std::uint16_t high = to_half(f[k]), low = to_half(f[k] - from_half(high));
    std::uint16_t *const columns = out + std::size_t{3} * static_cast<std::size_t>(k);
    columns[0] = columns[First ? 1 : 2] = high;
    columns[First ? 2 : 1] = low;
  }
  const double term = with_margin<Form>(f) / matrix_constant;
  out[own] = to_half(term);
  out[own + 1] = to_half_below(term - from_half(out[own]));
}

// ---- the same in float32, where no matrix unit is trusted ----

// The factors rounded to float32, and the additive term with a margin for that. Let S be the sum of (f_k^2 + g_k^2) / 2,
// |f| and |g|, u = 2^-24. A product has at most 3 rounding errors, of its factors and, without fma, its own; a term then
// goes through at most 5 additions. So the sum is within 8 u S (1 + 2^-19) = 2^-21 S (1 + 2^-19) of F, and the margins are
// 2^-20 S and 2^-9 for what underflows.
template <class Form, bool First> MEETC_HD inline void to_floats(const double *ball, placing where, float *out) {
  for (int k = 0; k < Form::products; ++k)
    out[k] = 0;
  if (where != placing::inside) {
    out[Form::products] = static_cast<float>(term_outside(where));
    return;
  }
  double f[Form::products + 1];
  if constexpr (First)
    Form::features_a(ball, f);
  else
    Form::features_b(ball, f);
  double squares = 0;
  for (int k = 0; k < Form::products; ++k) {
    out[k] = static_cast<float>(f[k]);
    squares += f[k] * f[k];
  }
  const double term = f[Form::products], size = std::fabs(term);
  out[Form::products] = static_cast<float>(term - (0x1p-20 * (squares / 2 + size) + 0x1p-10));
}
// Negative where F <= 0.
template <class Form> MEETC_HD inline float bilinear(const float *x, const float *y) {
  float sum = x[Form::products] + y[Form::products];
  for (int k = 0; k < Form::products; ++k)
    sum = ::fmaf(x[k], y[k], sum);
  return sum;
}

} // MEETC_NAMESPACE(meetc)

#endif
