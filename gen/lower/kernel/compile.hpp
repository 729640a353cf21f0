// The parts of compile(), one for each kind of kernel.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <optional>
#include <set>

namespace meetc::lower {

formula compile_formula(const model &m, const request &r);
// Compiles the sign that the body gives on stored operands. Nothing where the body does not give a sign.
std::optional<predicate> compile_sign(const model &m, const request &r);
predicate compile_predicate(const model &m, const request &r);

// The form with the fewest operations, and the first among equals, of forms of the same values.
program best_of(const builder &code, const std::vector<std::vector<node_id>> &forms);

// The kind whose blade a value with these coefficients is, or null: it has room for them, and no coefficient that the value
// lacks is fixed, as -1 is on the origin in the vector of a conformal point. Among several kinds the one with the least room,
// and among equal ones the first that is declared.
const lang::kind *kind_of_value(const model &m, const std::vector<blade> &blades);
std::vector<blade> sorted_blades(const metric &basis, const std::set<blade> &blades);

// Numbers become literals of every number type, so they must be small enough that float64 still counts in ones. Throws
// spec_error.
void check_constants(const program &p, const request &r);

} // namespace meetc::lower
