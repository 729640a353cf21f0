// Rotation invariants: a polynomial in the components of vectors, rewritten in their dot products, triple products and
// squared cross products. By the first fundamental theorem for SO(3), every rotation invariant polynomial is one in dot
// and triple products. The coefficients are found by exact linear algebra; code that is built from a form is expanded
// again and compared. This is the source of identities such as |a x b|^2 = a^2 b^2 - (a.b)^2 (Gram, Lagrange): B^2 of a
// meet is a Gram determinant (docs/paper.md).
#pragma once
#include "gen/poly/local_origin.hpp"

#include <optional>

namespace meetc::poly {

// One invariant of vectors i <= j (<= k).
struct invariant {
  enum class type { number, dot, triple, cross_squared } kind;
  int i, j, k; // number: i is the local variable
};

// p = form(invariants). The form is in a ring with one variable for each invariant.
struct vector_form {
  std::shared_ptr<ring> symbols;
  std::vector<invariant> invariants;
  poly form;
};

// Equivalent forms of p, the plainest first (dot and triple products only). Empty where p is not rotation invariant.
std::vector<vector_form> vector_forms(const local_origin &f, const poly &p);

} // namespace meetc::poly
