#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// Chooses the values that are stored beside an object (ir::program::stored): those that a pair reads, that depend on
// one object only, and that cost more than `cheapest` operations.
//
// A stored value costs the pair a load from memory that no other stage reads. A difference of two coordinates, or a
// square, costs one operation on numbers that the pair has loaded anyway, so recomputing it is cheaper. The cost of a
// value includes its operands', since the pair does not compute the operands of a stored value. In magnitudes a leaf counts
// as nothing: the pair computes that difference for the value in any case.
inline constexpr int cheapest = 1;

// Results and operations stay the same, so error bounds hold for stored values too: each is rounded as it would be in
// the pair. Only the split into work for each object and work for each pair changes.
ir::program store(const ir::program &p);

// The same for a program whose callers prepare objects themselves and call it many times: every value of one object that
// a pair reads is stored, whatever it costs. The pair then runs the fewest operations that this form allows.
ir::program keep(const ir::program &p);

} // namespace meetc::passes
