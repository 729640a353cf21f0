// Touching balls as a matrix product, from the spec's own predicate.
//
// A kind with a pad whose hull is one point is a ball. Let the spec have a predicate of two such balls that tests one
// sign, such as "the sign of (r + r')^2 - |c - c'|^2 is not negative". The polynomial of that sign is then separated
// into sum over k of f_k(X) g_k(Y), plus f(X) + g(Y): four products and two additive terms (in R(4,2), Lie's sphere
// geometry, it is one inner product). The form is also used for enclosing balls, which the scene's own kinds need not
// be: a triangle or a segment has an enclosing ball, and balls that do not touch rule a pair out.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/lower/expand/model.hpp"
#include "gen/poly/separate.hpp"

#include <memory>
#include <optional>
#include <string>

namespace meetc::lower {

struct ball_form {
  static constexpr int inputs = 4; // stored numbers of one ball
  static inline const std::string names[inputs] = {"x", "y", "z", "r"};

  const lang::predicate *of;           // the predicate with this sign
  std::shared_ptr<poly::ring> numbers; // stored numbers of X, then of Y
  poly::poly whole;                    // <= 0 where the balls touch; the products have the coefficients 1 and -1
  poly::separation parts;
  ir::program a, b; // f_0, f_1, ..., f and g_0, g_1, ..., g over the inputs of both
};

// Returns the form of the first predicate that has one; nothing where none does. The margins of the half-precision
// filter are proved for factors that are stored numbers and for |f|, |g| <= bound::matrix_additive. A predicate whose
// sign does not separate into such parts has no form.
std::optional<ball_form> find_ball_form(const model &m);

} // namespace meetc::lower
