// Predicates whose answer does not depend on which operand comes first.
//
// A set that is collided with itself then needs only half of its pairs. That is a property of the decision and not of the
// geometry, so it is proved of the decision: with the operands exchanged, its signs are again its signs, up to products and
// opposites, and the truth over them is the same one up to the order of the arguments of `and` and `or`.
//
// Limits: a predicate is only called symmetric where that proof succeeds. The exact answer is then symmetric, and so is that
// of every rung that is never wrong. That of a plain rung need not be, because it rounds other values.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// `kinds`: of the operands.
bool is_symmetric(const predicate &p, const std::vector<const lang::kind *> &kinds);

} // namespace meetc::lower
