// The relations that a kind states of its blade, as polynomials, and the samples that satisfy them.
//
// A relation that `is` holds identically in the stored numbers: its blade is expanded, and both sides are compared. One that
// holds `nearly` is what rounding makes true; the samples must satisfy it exactly. Neither reaches a sign, whose polynomial is
// that of the stored numbers.
#pragma once
#include "gen/lower/expand/model.hpp"

namespace meetc::lower {

// One coefficient of left - right.
struct stated_relation {
  std::size_t operand;
  const lang::relation *of;
  poly::poly zero;
};

// The relations on an operand whose blade's coefficients are the ring's variables from `first` on, at `blades`.
std::vector<stated_relation> relations_on(const model &m, const lang::kind &k, const std::vector<blade> &blades,
                                          const poly::ring &numbers, std::size_t operand, std::size_t first);

// Throws spec_error where a relation that `is` does not hold, or a sample has other blades than the kind or does not satisfy
// a relation.
void check_relations(const model &m, const lang::kind &k);

} // namespace meetc::lower
