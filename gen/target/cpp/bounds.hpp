// Error bounds as members of emitted stages and predicates.
#pragma once
#include "gen/target/cpp/predicate.hpp"

#include <string>

namespace meetc::target {

// A dyadic rational as an exact hexadecimal C++ literal; the suffix is "f" for float.
std::string hex_literal(const ir::rational &q, const char *suffix);

// Those that tell how wide integers must be.
std::string stage_widths_text(const bound::stage_bounds &b);
// The members of a stage: factor, box, magnitudes, extents, zeros, window.
std::string stage_bounds_text(const bound::stage_bounds &b, const emitted_stage &stage, const emitted_predicate &p);
// The members of a predicate: coincidences, axes.
std::string kernel_bounds_text(const bound::kernel_bounds &b, const emitted_predicate &p);

} // namespace meetc::target
