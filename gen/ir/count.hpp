// Counts the operations of a program.
#pragma once
#include "gen/ir/arena.hpp"

#include <string>

namespace meetc::ir {

// The operations that the results need if the values of `given` are known. Negations and scalings, which are products with
// powers of two, are counted apart, and not in the total.
struct counts {
  int multiplications = 0, additions = 0, fused = 0, scalings = 0, negations = 0;
  int total() const { return multiplications + additions + 2 * fused; }
};
// "5/3": multiplications and additions. A fused multiply-add is one of each.
std::string mul_add(const counts &c);
counts count(const arena &nodes, const std::vector<node_id> &results, const std::vector<node_id> &given = {});
// The same for the nodes of one residency only.
counts count(const arena &nodes, const std::vector<node_id> &results, residency where);
counts count(const program &p, residency where);
// The operations that run once for each object of A or B, to compute its stored values; and those that run for each
// pair, which reads them.
counts count_object(const program &p, residency object);
counts count_pair(const program &p);

} // namespace meetc::ir
