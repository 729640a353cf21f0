#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// Keeps the nodes that the results need, in their order. Lowering leaves others, since it tries several forms of a
// polynomial.
ir::program prune(const ir::program &p);

} // namespace meetc::passes
