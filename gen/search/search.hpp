// The search for cheap programs of several polynomials at once.
//
// Method: from one system (value_system.hpp) others are made, with pairs of variables changed (gen/poly/change.hpp) and with
// shorter representatives modulo its relations (gen/poly/modulo.hpp). Kernels are extracted from each (gen/poly/kernels.hpp),
// from the cheapest ones with more effort. The cheapest system becomes nodes by Horner schemes (gen/poly/scheme.hpp).
// The caller proves what it emits: it expands the nodes and, where relations were used, multiplies out the certificate.
// Limits: systems of more than 150 terms are left out, and so are long products and large coefficients.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/poly/price.hpp"
#include "gen/search/value_system.hpp"

namespace meetc::search {

// output - program = sum of multiplier * relation
struct certified_difference {
  std::size_t output, relation;
  poly::poly multiplier; // in the leaves
};

struct found_program {
  std::vector<ir::node_id> outputs;
  std::vector<certified_difference> differences; // empty where no relation was used
};

// group[v]: leaves of one group may be paired; -1 where a leaf stays. leaves[v]: the node of leaf v. `ring` is of the leaves.
std::optional<found_program> search_program(ir::arena &nodes, const poly::ring &ring,
                                            const std::vector<ir::node_id> &leaves, const value_system &from,
                                            const std::vector<int> &group, poly::price by);

} // namespace meetc::search
