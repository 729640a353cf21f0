// core/walk_cost.hpp: what a walk is expected to cost, by which the side that walks is chosen.
#ifndef MEETC_CORE_WALK_COST_HPP
#define MEETC_CORE_WALK_COST_HPP

#include "core/candidates.hpp"

namespace meetc {

// The expected number of boxes in the hierarchy of `tree` that the blocks of `walker` touch, or its elements where they
// are tested by their two points; each costs a test of sixteen lanes. Both sets have elements. The model: all boxes have
// their level's mean widths and lie anywhere in the box around both sets with equal probability. Two boxes then touch
// with the probability that the box of summed widths has in that box; a segment and a box touch with that of their
// Minkowski sum.
double expected_tests(const candidate_operand &walker, const candidate_operand &tree);

} // namespace meetc

#endif
