// A change of variables that shortens polynomials: v and w are replaced by v + w and v - w.
//
// Problem: v^2 - w^2 has two terms and (v + w)(v - w) one; in the numbers of a versor such pairs are idempotents at work, as
// the blades with and without no ^ ni of the conformal model are. They join terms across all outputs, where no factoring of
// one output sees them.
// Method: of all pairs of variables that may be paired, the one that shortens the sum of lengths most is taken; then the next,
// with disjoint pairs.
#pragma once
#include "gen/poly/packed.hpp"

namespace meetc::poly {

struct variable_pair {
  int v, w;        // replaced
  int plus, minus; // v + w and v - w
};

// The variable v of p in the other ones: v = (plus + minus) / 2, w = (plus - minus) / 2. The result is 2^degree times p, where
// degree is p's in v and w together, so that its coefficients are integers.
struct changed {
  packed of;
  int halvings; // the result is 2^halvings times p
};
changed change(const packed &p, const variable_pair &by);

// The pairs that shorten. group[v]: variables of one group may be paired; -1: not. New variables are numbered from `next`.
std::vector<variable_pair> shortening_pairs(std::vector<packed> all, const std::vector<int> &group, int next);

} // namespace meetc::poly
