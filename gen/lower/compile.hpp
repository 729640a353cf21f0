// The parts of compile(), one for each kind of kernel.
#pragma once
#include "gen/lower/kernel.hpp"

#include <optional>
#include <set>

namespace meetc::lower {

formula compile_formula(const model &m, const request &r);
// Compiles the sign that the body gives on stored operands. Nothing where the body does not give a sign.
std::optional<predicate> compile_sign(const model &m, const request &r);
predicate compile_predicate(const model &m, const request &r);

// Of two forms of the same values, the one with fewer operations.
program better_of(const builder &code, const std::vector<node_id> &x, const std::vector<node_id> &y);

std::vector<blade> sorted_blades(const std::set<blade> &blades);

// Numbers become literals of every number type, so they must be small enough that float64 still counts in ones. Throws
// spec_error.
void check_constants(const program &p, const request &r);

} // namespace meetc::lower
