// What a kernel of two operands computes as sums of products f(X) g(Y): how wide all pairs are as a matrix product.
#pragma once
#include "gen/lower/declared.hpp"
#include "gen/poly/separate.hpp"

namespace meetc::lower {

struct separated {
  std::string group, label; // "common", "s[0]"; "", "e1^n"
  poly::separation parts;
};

// Signs by stage, in the stored numbers; a formula's values on general blades. Nothing where there are not two operands.
std::vector<separated> separate(const model &m, const kernel &k);
// A formula's values, and "norm2", in the declared basis.
std::vector<separated> separate(const declared_formula &f);

} // namespace meetc::lower
