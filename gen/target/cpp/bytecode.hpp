// A stage's program as bytecode, for integers of any width (runtime/kernel/meetc/decide/bytecode.hpp).
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <string>

namespace meetc::target {

// The members registers, instruction_count and instruction_at of a stage. The first registers hold the inputs.
std::string bytecode_text(const ir::program &p, int inputs);

} // namespace meetc::target
