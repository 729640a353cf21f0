// A program in readable form: one line for each node, with its residency.
#pragma once
#include "gen/ir/arena.hpp"

#include <string>

namespace meetc::ir {

// Writes "  %7 = multiply %3 %5  ; pair" for every node that the results need, then "  result[0] = %7". `inputs` are
// names.
std::string print(const program &p, const std::vector<std::string> &inputs);

const char *name_of(residency where); // "scene", "A", "B", "pair"

} // namespace meetc::ir
