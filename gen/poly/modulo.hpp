// Short representatives of polynomials modulo relations.
//
// Problem: where N = 1 holds of a versor's numbers, its quadratic forms have several expressions, and the one with the fewest
// terms is rarely the expanded one.
// Method: constants times (multiplier * relation) are subtracted, each of which cancels a term. The multipliers are the
// quotients of the polynomial's terms by the relation's. The number of terms descends; where none is left that shortens, a
// random step that does not lengthen is taken, from a fixed seed. Every step is kept, so f - g = sum of steps is a proof.
// Limits: a relation of higher degree, or of a multiplier that no term suggests, is not found.
#pragma once
#include "gen/poly/packed.hpp"

namespace meetc::poly {

// factor * multiplier * relation, which was subtracted.
struct reduction {
  std::size_t relation;
  product_of multiplier;
  std::int64_t factor;
};

struct reduced {
  packed of;
  std::vector<reduction> steps; // one for each relation and multiplier
};

// A short representative of p. `seed` 0 takes no random step.
reduced shortened(const packed &p, const std::vector<packed> &relations, unsigned seed);

// p - factor * multiplier * q
packed subtracted(const packed &p, const packed &q, product_of multiplier, std::int64_t factor);

} // namespace meetc::poly
