// Predicates that hold exactly if the boxes of their operands touch.
//
// A search that has compared the boxes in float32 has then decided the pair. That is proved of the decision: it is the same
// truth as the comparisons of the boxes' ends, which are stored numbers.
//
// Limits: a predicate is called so only if that proof succeeds. Each end of an operand's box must be one stored number,
// by a rule of its kind, and the operand has no pad.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// `kinds`: of the operands.
bool is_by_boxes(const model &m, const predicate &p, const std::vector<const lang::kind *> &kinds);

} // namespace meetc::lower
