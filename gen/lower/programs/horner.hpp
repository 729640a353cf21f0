// Multivariate Horner schemes: a polynomial over values that a program has, as nodes.
//
// Method: the variable that saves most is taken out, p = v * quotient + rest, and both parts are treated alike. Up to a
// number of terms the savings are found by search, else by how often a variable occurs. Coefficients are ignored there,
// and so is sharing between the parts.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/poly/price.hpp"

namespace meetc::lower {

// The price of an operation in the search. `whole`: each counts, and a value of the pair is taken out first among
// equals, so that values of one object gather in factors of that object. `pair`: only operations on values of the pair
// count, and products and sums join the values of one object before the rest.
using poly::price;

// leaves[v] is the node of variable v; those of variables that do not occur may be -1.
ir::node_id horner(ir::arena &nodes, const poly::poly &p, const std::vector<ir::node_id> &leaves, price by);

} // namespace meetc::lower
