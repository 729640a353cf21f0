// Programs on blades that take the relations of the operands' kinds for granted.
//
// A relation never changes what a formula means: its polynomials stay, and beside them stand those of the program, with a
// certificate that multiplies out, polynomial - computed = sum of multiplier * relation. Signs are made of the polynomials of
// stored numbers elsewhere, and see no relation.
#pragma once
#include "gen/lower/kernel/kernel.hpp"
#include "gen/search/assumed.hpp"

namespace meetc::lower {

// Fills in `assumed`, `prepared` and `prepared_assumed` of a formula that has its exact program, and replaces that program
// where a cheaper one assumes something. supports: of the operands; `subject` has no relations yet; `written`: see
// gen/search/assumed.hpp.
void assume(const model &m, const request &r, const std::vector<std::vector<blade>> &supports,
            search::product_subject subject, const std::vector<node_id> &leaves,
            const search::written_programs &written, builder &code, formula &out);

} // namespace meetc::lower
