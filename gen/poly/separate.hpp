// A polynomial in the numbers of two objects as a sum of products, sum over k of f_k(X) g_k(Y).
//
// Problem: to evaluate the polynomial for all pairs of two sets is a matrix product, of the rows f(X_i) by the columns
// g(Y_j), whose inner dimension is the number K of terms. What is the least K?
//
// Method: the coefficients of p form a matrix with a row for each monomial in X and a column for each monomial in Y. A
// sum of K products is a factorisation of that matrix through dimension K, so the least K is its rank, which exact
// elimination finds. A term with a constant side, f(X) * 1 or 1 * g(Y), is cheaper than a product; it is split off if K
// stays the least. The rest is written with rows of the matrix as g_k, or with columns of it as f_k (an interpolative
// factorisation), whichever has fewer monomials. If the monomials of one side are independent, each stands alone. The
// same polynomial always gives the same terms.
//
// Limits: the elimination is sparse and rational, for matrices of some hundred rows.
//
// Limits: sparse rational elimination, for matrices of some hundred rows.
#pragma once
#include "gen/poly/poly.hpp"

namespace meetc::poly {

struct product {
  poly f, g; // f is in X's variables, primitive with a positive leading coefficient; g in Y's. Neither is constant
};

struct separation {
  std::vector<product> products;
  poly of_x, of_y; // the additive terms; zero where there is none. A lone constant is in of_x

  int additive() const { return !of_x.is_zero() + !of_y.is_zero(); }
  int terms() const { return static_cast<int>(products.size()) + additive(); } // K
};

// Variables below `first_of_y` are X's; the others are Y's.
separation separate(const poly &p, int first_of_y);

// The sum of the terms, which is the polynomial that was separated.
poly to_poly(const separation &s);

} // namespace meetc::poly
