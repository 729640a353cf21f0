// Forms of values that are products of a known structure, recognised by their polynomials and not by how they were written.
//
//   V X ~V            = N X + (V X - X V) ~V, where N stands for V ~V. The commutator has few coefficients, and the values
//                       N and V X - X V are shared by all outputs. No relation is needed; where a kind states one, N is a
//                       number.
//   B B of degree 2   = a (X.X) (Y.Y) + b |<X Y>_k|^2 for a grade k, in the algebra's own metric: the identities of Gram
//                       (k = 0) and Lagrange.
//
// Limits: two operands; the constants a and b are solved for, and every form is compared with the polynomials exactly.
#pragma once
#include "gen/algebra/multivector.hpp"
#include "gen/search/search.hpp"

#include <map>

namespace meetc::search {

using algebra::blade;
using algebra::metric;
using algebra::rational;
using multivector = algebra::multivector<poly::poly>;

// A form, and what it left out where relations were used.
struct known_form {
  value_system system;
  std::vector<certified_difference> differences; // multipliers in the leaves
};

// The operands' coefficients and the values by blade, in one ring. Relations are polynomials of that ring.
struct product_subject {
  const metric &basis;
  const poly::ring &numbers;
  std::vector<multivector> operands;
  std::vector<blade> result;
  std::vector<poly::poly> values;
  std::vector<poly::poly> relations = {};
};
std::vector<known_form> product_forms(const product_subject &of);

multivector reversed(const multivector &m);

} // namespace meetc::search
