// Counts the operations of a program.
#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::ir {

// The operations that the results need. Negations, constants and products with powers of two are free.
struct counts {
  int multiplications = 0, additions = 0, fused = 0;
  int total() const { return multiplications + additions + 2 * fused; }
};
counts count(const arena &nodes, const std::vector<node_id> &results);
// The same for the nodes of one residency alone.
counts count(const program &p, residency where);

} // namespace meetc::ir
