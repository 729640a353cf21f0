#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// Turns a product that is used once, in a sum, into a fused multiply-add, which saves one rounding and one instruction.
//
// A product and a sum of different residency stay apart: a value of one object must not be drawn into the pair. The
// numbers of multiplications and additions do not change.
ir::program fuse(const ir::program &p);

} // namespace meetc::passes
