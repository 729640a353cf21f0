// Touching balls as a matrix product, from the spec's own predicate.
//
// A kind whose hull is one point and that has a pad is a ball. Where the spec has a predicate of two such balls that is the
// test of one sign, as "the sign of (r + r')^2 - |c - c'|^2 is not negative", the polynomial of that sign is separated into
// sum over k of f_k(X) g_k(Y), plus f(X) + g(Y): four products and two additive terms (in R(4,2), Lie's sphere geometry,
// it is one inner product). It is used for balls that a scene need not have: a triangle or a segment has a ball around
// it, and balls that do not touch rule a pair out.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/lower/model.hpp"
#include "gen/poly/separate.hpp"

#include <memory>
#include <optional>
#include <string>

namespace meetc::lower {

struct ball_form {
  static constexpr int inputs = 4; // of one ball
  static inline const std::string names[inputs] = {"x", "y", "z", "r"};

  const lang::predicate *of;           // whose sign it is
  std::shared_ptr<poly::ring> numbers; // of X, then of Y
  poly::poly whole;                    // <= 0 where the balls touch; the products have the coefficients 1 and -1
  poly::separation parts;
  ir::program a, b; // f_0, f_1, ..., f and g_0, g_1, ..., g over the inputs of both
};

// From the first predicate that gives one; nothing where none does. The margins of the filter in half precision are proved
// for factors that are stored numbers and for |f|, |g| <= bound::matrix_additive; a predicate whose sign does not separate
// into such parts gives none.
std::optional<ball_form> find_ball_form(const model &m);

} // namespace meetc::lower
