#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::passes {

// Chooses the values of one object that are stored beside it (ir::program::stored): those that a pair reads, that one
// object alone decides, and that cost more operations than `cheapest`.
//
// A stored value costs the pair a load, from memory that no other stage reads. A difference of two coordinates, or a
// square, costs one operation on numbers that the pair has loaded anyway: recomputing it beats loading it. Operations
// count with all that they need, since what a stored value needs is not computed for the pair.
inline constexpr int cheapest = 1;

// Results and operations stay as they are, so error bounds hold for stored values as for others: each is rounded as it
// would be in the pair. Only what runs once an object, and what once a pair, changes.
ir::program store(const ir::program &p);

} // namespace meetc::passes
