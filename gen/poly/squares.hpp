// Squares in forms: the identities by which a polynomial in dot products becomes shorter than any factoring makes it.
//
// Problem: B^2 of a meet is a Gram determinant, and expanded it has more terms than it needs. In r^2 N^2 - (N.c)^2 +
// 2 d (N.c) - d^2 the value N.c - d occurs squared, and in t^2 D^2 - 2 t w (D.v) + w^2 v^2 the vector t D - w v does.
// No factoring finds either, since the whole is irreducible.
//
// Method: a form is a polynomial in symbols. A symbol is an invariant (invariants.hpp) or is made of the symbols before
// it. Two rewritings, each of a form into a form of the same polynomial, are repeated on their own results:
//   complete_square   a q^2 + b q + c = a (q + b/2a)^2 + c - b^2/4a, where the quotient b/2a is a polynomial; where it is not,
//                     its whole part s is taken, a (q + s)^2 + (b - 2 a s) q + c - a s^2, if that is shorter;
//   length            k (a^2 u.u + 2 a b u.v + b^2 v.v) = k |a u + b v|^2, for vectors u, v and polynomials a, b.
// All forms that arise are returned; which one is best depends on what is stored and is not decided here.
//
// Check: squares() expands each form that it returns and compares it with the form that it was given.
// Limits: squares of one symbol and of sums of two vectors; at most most_made rewritings, one after the other.
#pragma once
#include "gen/poly/invariants.hpp"

namespace meetc::poly {

// A value made of the symbols before it.
struct made_symbol {
  enum class type { sum, length } kind;
  poly first, second; // sum: first; length: |first u + second v|^2
  int u = -1, v = -1; // vectors of the local origin
};

struct form {
  std::shared_ptr<ring> symbols; // invariants, then made symbols, then spare names
  std::vector<invariant> invariants;
  std::vector<made_symbol> made;
  poly value;

  // The ring's variable of made symbol i.
  int symbol(std::size_t i) const { return static_cast<int>(invariants.size() + i); }
};

inline constexpr int most_made = 4;

// Every form that complete_square and length make of v, without v itself. A difference between a form and v throws
// std::logic_error.
std::vector<form> squares(const vector_form &v);

// The polynomial of a form, in the form's own invariants.
poly expanded(const form &of);

} // namespace meetc::poly
