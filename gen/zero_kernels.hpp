// Kernels that are zero for all operands, as a meet is where I^2 = 0. A definition may be zero, but who asks for such a kernel
// hardly means it, unless the scene says so in `zero`.
#pragma once
#include "gen/driver.hpp"

namespace meetc {

// Warns of each kernel of the scene that is zero and not listed. Throws spec_error where the scene lists a kernel that it
// does not ask for, or one that is not zero.
void tell_zero_kernels(const compilation &c);

} // namespace meetc
