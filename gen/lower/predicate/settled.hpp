// Equal points that settle a decision.
//
// Problem: two closed sets that share a stored corner touch, and meshes are full of such pairs. Which coincidences of
// points imply a hit depends on the predicate: a ball that is centred at a corner touches it, a sphere does not.
//
// Method: nothing is known of the geometry. The points are made equal in the exact polynomials of the atoms, which are
// then factored and merged as atoms again, so that some signs are zero, some are equal or opposite, and some are
// squares. A coincidence settles the decision if it is then true for all signs of the remaining atoms. This is proved
// in three-valued logic with all of them unknown, and where that does not suffice, by cases over the sign of an atom.
//
// Limits: the proof takes atoms for independent, so it finds no hit that rests on a relation between polynomials. The
// work is bounded; a claim that is not proved within the bound is not made.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::lower {

// Whether it is proved that all operands at which the coincidences hold are a hit that no reject line denies.
bool is_settled_by(const predicate &p, const std::vector<bound::coincidence> &all);

// Fills settled_by: each coincidence that settles the decision alone, then each two that do so together and not alone.
// A coincidence that makes no sign zero is added to out.coincidences if it settles the decision.
void find_settled(const predicate &p, bound::kernel_bounds &out);

} // namespace meetc::lower
