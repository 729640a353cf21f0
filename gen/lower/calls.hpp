// Decisions that are parts of decisions: where a predicate calls another one.
#pragma once
#include "gen/lower/kernel.hpp"

namespace meetc::lower {

// Finds the calls of which the callee's own decision, on the signs that the call took, is the very truth that stands there.
void find_calls(const model &m, const std::vector<predicate_call> &calls, predicate &caller);

} // namespace meetc::lower
