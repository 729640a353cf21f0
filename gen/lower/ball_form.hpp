// Touching balls as a matrix product.
//
// Two balls (x, y, z, r) touch where |c - c'|^2 <= (r + r')^2. Half the difference of the sides is separated into
// sum over k of f_k(X) g_k(Y), plus f(X) + g(Y): four products and two additive terms (in R(4,2), Lie's sphere geometry,
// it is one inner product). It is written for balls that a scene need not have: a triangle or a segment has a ball
// around it, and balls that do not touch rule a pair out.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/poly/separate.hpp"

#include <memory>
#include <string>

namespace meetc::lower {

struct ball_form {
  static constexpr int inputs = 4; // of one ball
  static inline const std::string names[inputs] = {"x", "y", "z", "r"};

  std::unique_ptr<poly::ring> numbers; // of X, then of Y
  poly::poly whole;                    // the difference of the sides, halved
  poly::separation parts;
  ir::program a, b; // f_0, f_1, ..., f and g_0, g_1, ..., g over the inputs of both
};

ball_form make_ball_form();

} // namespace meetc::lower
