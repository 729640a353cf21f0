// Predicates that hold exactly if two closed balls touch.
//
// A search that compares the balls by their boxes (runtime/core/hierarchy/two_balls.hpp) has then decided most pairs. That is
// proved of the decision: it is one comparison of the same polynomial, the square of the sum of the radii less that of
// the distance of the centres, with zero.
//
// Limits: a predicate is called so only if that proof succeeds. Each operand's hull must be one point with its
// coordinates as they are stored. If it has a pad, that is the radius, and the kind's rule must say that it is not
// negative. There is no reject stage.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// `kinds`: of the operands.
bool is_by_balls(const model &m, const predicate &p, const std::vector<const lang::kind *> &kinds);

} // namespace meetc::lower
