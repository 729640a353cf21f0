// A stage's program as bytecode, for integers of any width (runtime/kernel/meetc/bytecode.hpp).
#pragma once
#include "gen/lower/kernel.hpp"

#include <string>

namespace meetc::target {

// The members registers, instruction_count and instruction_at of a stage. Inputs stand in the first registers.
std::string bytecode_text(const ir::program &p, int inputs);

} // namespace meetc::target
