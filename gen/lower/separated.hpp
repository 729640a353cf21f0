// The values of a kernel of two operands as sums of products f(X) g(Y), whose number is the inner dimension of the
// matrix product that evaluates all pairs.
#pragma once
#include "gen/lower/declared.hpp"
#include "gen/poly/separate.hpp"

namespace meetc::lower {

struct separated {
  std::string group, label; // "common", "s[0]"; "", "e1^n"
  poly::separation parts;
};

// Signs by stage, in the stored numbers, or a formula's values on general blades. Nothing unless there are two
// operands.
std::vector<separated> separate(const model &m, const kernel &k);
// A formula's values, and "norm2", in the declared basis.
std::vector<separated> separate(const declared_formula &f);

} // namespace meetc::lower
