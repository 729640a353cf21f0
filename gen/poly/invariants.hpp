// Rotation invariants: a polynomial in the components of vectors, rewritten in their dot products, triple products
// and squared cross products. By the first fundamental theorem for SO(3) every rotation invariant polynomial is
// one in dot and triple products; the coefficients are found by exact linear algebra, and whoever builds code from
// a form expands it again and compares. This is where identities such as
// |a x b|^2 = a^2 b^2 - (a.b)^2 (Gram, Lagrange) come from: B^2 of a meet is a Gram determinant (docs/paper.md).
#pragma once
#include "gen/poly/frame.hpp"

#include <optional>

namespace meetc::poly {

// One invariant of vectors i <= j (<= k).
struct invariant {
  enum class type { number, dot, triple, cross_squared } kind;
  int i, j, k; // number: i is the local variable
};

// p = form(invariants), form in a ring with one variable an invariant.
struct vector_form {
  std::shared_ptr<ring> symbols;
  std::vector<invariant> invariants;
  poly form;
};

// Equivalent forms of p, plainest (dot and triple products alone) first; empty when p is not rotation invariant.
std::vector<vector_form> vector_forms(const frame &f, const poly &p);

} // namespace meetc::poly
