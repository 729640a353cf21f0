// Sub-decisions: the places where a predicate calls another one.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// Finds the calls whose truth equals the callee's own decision on the signs that the call took.
void find_calls(const model &m, const std::vector<predicate_call> &calls, predicate &caller);

} // namespace meetc::lower
