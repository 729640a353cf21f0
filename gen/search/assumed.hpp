// Programs that take the operands' relations for granted, and programs for one versor and many objects.
#pragma once
#include "gen/search/searched_forms.hpp"

#include <functional>

namespace meetc::search {

// The programs that follow how the author wrote the values, for operands of which some coefficients are numbers: the nodes of
// all values, a program each.
using written_programs = std::function<std::vector<std::vector<ir::node_id>>(const std::vector<multivector> &operands)>;

// The cheapest program under the subject's relations. Nothing where no relation makes one cheaper than `to_beat` operations.
// A coefficient that a relation says to be a number is not read.
std::optional<found_program> under_relations(ir::arena &nodes, const product_subject &of,
                                             const std::vector<ir::node_id> &leaves, const written_programs &written,
                                             int to_beat);

// sum of m_j y_j, where the values m_j depend on one operand alone: for values that are linear in the other one and of a higher
// degree in that. The m_j are searched for at the whole price, and use the subject's relations.
std::optional<found_program> prepared(ir::arena &nodes, const product_subject &of,
                                      const std::vector<ir::node_id> &leaves);

} // namespace meetc::search
