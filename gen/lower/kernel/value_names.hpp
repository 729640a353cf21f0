// Names of values in emitted formulas.
//
// Problem: searches and passes write the programs, whose nodes know nothing of the spec, and a reader knows the spec's values.
// Method: the values that the spec names are evaluated at two of the points of gen/ir/residue.hpp, and a node with the same
// residues is that value. An agreement by chance could make a name wrong, but no value.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// Fills in program::names of a formula, after the last pass: the coefficients of calls (meet_e1_e2, norm2), of X ~X
// (rnorm2_X), of X Y - Y X (bracket_e1), of stored operands' blades (X_e1), and of the result (B_e1).
void name_values(const model &m, kernel &k);

} // namespace meetc::lower
