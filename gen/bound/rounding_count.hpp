// The rounding error of a program whose value is wanted, as a formula's is.
//
// Claim: |computed - exact| <= ((1 + u)^n - 1) M, barring under- and overflow, where M is the program on the magnitudes of its
// inputs and constants with a sum for each difference, and n counts the roundings on the way: each sum and product adds one, a
// product adds up those of its factors, and a sum takes the greater number. With a fused multiply-add there are fewer of them,
// so the bound holds for both schedules (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 3.1).
#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::bound {

// n, the largest over the results. Inputs are exact, and so are constants that binary32 can represent and products with 2, 4,
// 8, ...; a constant p/q is a quotient, rounded with its parts.
int rounding_count(const ir::program &p);

} // namespace meetc::bound
