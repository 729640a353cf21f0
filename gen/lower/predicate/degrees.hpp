// The degrees of signs in the numbers of their operands, and what to write where they do not fit.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// A versor that is unit only up to rounding has a sign of its own where the sign's polynomial is homogeneous in its numbers:
// that of the versor divided by its length. Elsewhere the sign would be that of a scaled image. Both functions throw
// spec_error with the terms to multiply by the square of the length: the first for kinds that state a relation which holds
// nearly, the second for all kinds whose blade has several grades.
void check_degrees(const request &r, const predicate &p);
void check_versors(const model &m, const request &r, const predicate &p);

// Throws: no groups of the stored numbers make a sign homogeneous, or a constant is no integer. Names terms to multiply.
[[noreturn]] void refuse_degrees(const request &r, const predicate &p);

} // namespace meetc::lower
