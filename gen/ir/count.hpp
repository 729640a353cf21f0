// Counts the operations of a program.
#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::ir {

// Of what the results need, when the values of `given` are there. Negations, constants and products with powers of two
// are free.
struct counts {
  int multiplications = 0, additions = 0, fused = 0;
  int total() const { return multiplications + additions + 2 * fused; }
};
counts count(const arena &nodes, const std::vector<node_id> &results, const std::vector<node_id> &given = {});
// Of the nodes of one residency alone.
counts count(const program &p, residency where);
// What runs once an object of A or B, for its stored values; what runs for each pair, which reads them.
counts count_object(const program &p, residency object);
counts count_pair(const program &p);

} // namespace meetc::ir
