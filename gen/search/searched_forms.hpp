// Every program that the searches find for the values of one product of operands.
#pragma once
#include "gen/search/product_forms.hpp"

namespace meetc::search {

// leaves[v]: the node of variable v of the subject's ring. Programs whose `differences` are empty have the values exactly.
std::vector<found_program> searched_forms(ir::arena &nodes, const product_subject &of,
                                          const std::vector<ir::node_id> &leaves, poly::price by);

// Whether a value holds numbers of one operand squared or multiplied with each other.
bool repeats_an_operand(const product_subject &of);

// Multiplies out the certificate: whether value - program = sum of multiplier * relation, where `program` is its polynomials.
bool is_certified(const product_subject &of, const std::vector<certified_difference> &differences,
                  const std::vector<poly::poly> &program);

} // namespace meetc::search
