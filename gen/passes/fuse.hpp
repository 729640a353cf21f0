#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// A product that is used once, in a sum, becomes a fused multiply-add: one rounding and one instruction less.
//
// Products of another residency than the sum stay apart: a value that one object alone decides is computed once for the
// object and must not be drawn into the pair. Counts of multiplications and additions do not change.
ir::program fuse(const ir::program &p);

} // namespace meetc::passes
