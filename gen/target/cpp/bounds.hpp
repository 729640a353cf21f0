// Error bounds as members of emitted stages and predicates.
#pragma once
#include "gen/bound/bound.hpp"
#include "gen/lower/kernel.hpp"

#include <string>

namespace meetc::target {

// A dyadic rational as a hexadecimal C++ literal, exact; suffix "f" for float.
std::string hex_literal(const ir::rational &q, const char *suffix);

// Members of a stage: factor, box, magnitudes, extents, zeros, window.
std::string stage_bounds_text(const bound::stage_bounds &b, const lower::stage &s, int inputs_a);
// Members of a predicate: coincidences, axes.
std::string kernel_bounds_text(const bound::kernel_bounds &b, int inputs_a);

} // namespace meetc::target
