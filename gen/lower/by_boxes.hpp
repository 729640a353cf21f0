// Predicates that hold exactly where the boxes of their operands touch.
//
// A search that has compared the boxes in float32 has then decided the pair. That is proved of the decision: it is the same truth
// as the comparisons of the boxes' ends, which are stored numbers.
//
// Limits: a predicate is only called so where that proof succeeds. Of an operand each end of its box must be one stored number,
// by a rule of its kind, and it has no pad.
#pragma once
#include "gen/lower/kernel.hpp"

namespace meetc::lower {

// `kinds`: of the operands.
bool is_by_boxes(const model &m, const predicate &p, const std::vector<const lang::kind *> &kinds);

} // namespace meetc::lower
