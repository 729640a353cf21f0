// Operands that the command line names.
#pragma once
#include "gen/lower/expand/model.hpp"

namespace meetc {

// 'S: sphere, L: line' as names and kinds. Throws spec_error.
std::vector<std::pair<std::string, std::string>> named_kinds(const lower::model &m, const std::string &text);

// One operand with the numbers that it stores, in memory order.
struct given_operand {
  std::string name;
  const lang::kind *kind;
  std::vector<lower::rational> numbers;
};

// 'S: sphere = 0, 0, 1/2, 1.5; N: direction = 1, 0, 1e-3', exactly. Throws spec_error: also where the numbers are none of the
// kind's valid elements.
std::vector<given_operand> given_operands(const lower::model &m, const std::string &text);

} // namespace meetc
