// Polynomials packed for searches that rewrite them thousands of times: a monomial is one 128-bit word, a coefficient a small
// integer. Nothing here proves anything: a program that a search finds is expanded again by its caller.
#pragma once
#include "gen/poly/poly.hpp"

#include <cstdint>
#include <functional>

namespace meetc::poly {

// A product of at most most_factors variables: in each lane of 16 bits a variable's number plus 1, the greatest in the lowest
// lane. 0 is the product of none.
__extension__ using product_of = unsigned __int128;
inline constexpr int lane_bits = 16, most_factors = 8;
inline constexpr int most_variables = (1 << lane_bits) - 2;

// The variable in the lowest lane. Only for a product of at least one.
constexpr int first_factor(product_of f) {
  return static_cast<int>(f & 0xffff) - 1;
}
constexpr product_of rest_of(product_of f) {
  return f >> lane_bits;
}
constexpr product_of factor(int variable) {
  return static_cast<product_of>(variable) + 1;
}
int degree(product_of f);
product_of times(product_of a, product_of b); // their degrees add up to most_factors at most
bool divides(product_of divisor, product_of f);
product_of divided(product_of f, product_of divisor); // where it divides
product_of common(product_of a, product_of b);        // the greatest common divisor

struct packed_term {
  product_of of;
  std::int64_t coefficient;
  auto operator<=>(const packed_term &) const = default;
};
using packed = std::vector<packed_term>; // by `of`, without zeros

// The terms sorted, and equal products joined.
packed joined(std::vector<packed_term> terms);
// The quotient by a product of the terms that it divides; the others.
packed quotient(const packed &p, product_of divisor);
packed remainder(const packed &p, product_of divisor);
// The greatest common divisor of the coefficients, with the sign of the first one; 0 for none.
std::int64_t content(const packed &p);
packed divided(packed p, std::int64_t content);
int degree(const packed &p);
std::vector<int> variables(const packed &p); // ascending

// A polynomial as a rational number times a packed one with coprime coefficients. Nothing where it does not fit.
struct scaled_packed {
  rational content;
  packed of;
};
std::optional<scaled_packed> pack(const poly &p);
poly unpack(const packed &p, const ring &r);

struct packed_hash {
  std::size_t operator()(const packed &p) const;
};

} // namespace meetc::poly
