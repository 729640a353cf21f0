// The key `contacts` of predicates: which operands may have it, and the signs that it names.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// The function that the kernel calls, or null.
const lang::function *function_of(const model &m, const request &r);

// The number of points of which an element consists; 0: of other numbers too.
int points_of(const model &m, const lang::kind &k);

// Throws spec_error where the operands have no contacts of the kind that the predicate names. They are two or three points and
// three, a ball and a segment, or, for a witness, a ball and another one or three points. A ball has four numbers.
void check_contacts(const model &m, const lang::predicate &p);

// The kind of the first operand of a function that tells contacts, if the kernel is one of a kind of three points, or of balls,
// and of a point. Throws spec_error for one that is no sign.
const lang::kind *sides_of(const model &m, const request &r, bool is_sign);

} // namespace meetc::lower
