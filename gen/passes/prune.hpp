#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// The nodes that the results need, in their order, and no others: lowering tries several forms of a polynomial.
ir::program prune(const ir::program &p);

} // namespace meetc::passes
