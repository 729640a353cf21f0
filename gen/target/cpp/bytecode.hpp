// A stage's program as steps on integers of any width (runtime/kernel/meetc/integers.hpp).
#pragma once
#include "gen/lower/kernel.hpp"

#include <string>

namespace meetc::target {

// The members places, step_count and step_at of a stage. Inputs stand in the first places.
std::string steps_text(const ir::program &p, int inputs);

} // namespace meetc::target
