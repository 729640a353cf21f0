// The margin that makes a product of half-precision matrices a certified filter of touching balls.
//
// Problem: F = sum over k of f_k g_k, plus f + g, is <= 0 where two balls touch (gen/lower/ball_form.hpp). A matrix
// unit computes D from parts in fp16. Find margins m(X), m(Y), to be subtracted from f and g, such that F <= 0 implies
// D < 0.
//
// The computation. Numbers are scaled and shifted so that |x|, |y|, |z|, r <= 2^11.
//   parts      f_k = h + l + error, h = f_k rounded to 11 bits, l = (f_k - h) rounded to 11 bits; parts below 2^-14 may
//              be replaced by 0 (no operand is subnormal). Hence h = f_k (1 + e) + s and l = (f_k - h) (1 + e') + s'
//              with |e|, |e'| <= 2^-11 and |s|, |s'| <= 2^-14. The same for g_k.
//   products   h h', h l' and l h' are kept; each has at most 22 bits and is exact in fp32.
//   additive   a = f - m as 2^8 (h + l), h and l in fp16, h within one step of a / 2^8 and the sum at most a; parts below
//              2^-14 may be replaced by 0 or by -2^-14. Each is a product with the constant 2^8, which is exact as well.
//   the sum    of the 16 products t_i is D with |D - sum t_i| <= 17 * 2^-23 sum |t_i|. This is assumed of the unit, in
//              whatever order it adds, whether or not it rounds, truncates or flushes subnormals.
// With e = 2^-23 for short:
//   a product  |h h' + h l' + l h' - f g| <= 3 * 2 e |f g| + 2^-14 (|f| + |g|) + smaller terms. The three terms of 2 e =
//              2^-22 are the omitted l l' and the residues of f and of g. The unit adds 17 e (|h h'| + |h l'| + |l h'|)
//              <= 17.04 e |f g|. The sum is 23.04 e |f g|, so 24 suffices; and |f g| <= (f^2 + g^2) / 2 gives each
//              object its half.
//   linear     2^-14 |f_k| (1 + 3 * 2^-11), which is less than 65/64 * 2^-14 |f_k|.
//   additive   17 e (|h| + |l|) 2^8 <= 17.04 e (|f| + m), so 18 e |f| suffices.
//   absolute   the unit's error on m itself: m < 39, and 17.04 e m < 2^-13. 2^-11 is left for the errors of shifting,
//              scaling and computing f and m; terms quadratic in 2^-14 are far below. The sum is less than 2^-10.
// gen/target/gappa/ball_filter.cpp writes all of this for Gappa, which proves the claim.
#pragma once
#include "gen/algebra/metric.hpp"

namespace meetc::bound {

// The number numerator * 2^exponent.
struct dyadic {
  int numerator, exponent;
  algebra::rational value() const {
    algebra::rational q(numerator);
    if (exponent < 0)
      mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    else
      mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    return q;
  }
};

// The assumptions.
inline constexpr dyadic matrix_input{1, 11};        // the largest |input|
inline constexpr dyadic matrix_additive{3, 21};     // |f| for such inputs: (x^2 + y^2 + z^2 - r^2) / 2
inline constexpr dyadic matrix_part{1, -11};        // half a step of fp16, relative
inline constexpr dyadic matrix_step{1, -10};        // a step of fp16, relative
inline constexpr dyadic matrix_flush{1, -14};       // the least part that is not replaced
inline constexpr dyadic matrix_unit{1, 8};          // the factor of an additive part
inline constexpr dyadic matrix_accumulate{17, -23}; // the unit's error, relative to the sum of the products' magnitudes
inline constexpr dyadic matrix_evaluate{1, -11};    // what is lost before the split, for each object

// m = square * sum f_k^2 + additive * |f| + linear * sum |f_k| + absolute.
inline constexpr dyadic margin_square{12, -23};
inline constexpr dyadic margin_additive{18, -23};
inline constexpr dyadic margin_linear{65, -20};
inline constexpr dyadic margin_absolute{1, -10};

} // namespace meetc::bound
