// A formula in the basis that the spec declares, for the targets JSON and LaTeX.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// The operands are given by their coefficients X.e1^e2 in that basis. Linear relations between the coefficients of a
// kind (such as equal e and eb parts) are used to eliminate some of them, so that each value has one name.
struct declared_formula {
  std::shared_ptr<poly::ring> numbers;
  int numbers_of_x = 0;                           // how many numbers belong to the first operand
  std::vector<std::vector<basis_blade>> supports; // of the operands
  std::vector<basis_blade> blades;
  std::vector<poly::poly> values; // for each blade
  poly::poly norm2;               // the scalar part of the value's square
};
declared_formula in_declared_basis(const model &m, const request &r);

} // namespace meetc::lower
