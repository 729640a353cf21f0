// A stage's program as steps on integers of any width (meet/integers.hpp).
#pragma once
#include "gen/dag/kernel.hpp"

#include <string>

namespace meetc::emit {

// The members places, step_count and step_at of a stage. Inputs stand in the first places.
std::string steps_text(const dag::program &p, int inputs);

} // namespace meetc::emit
