// The values that sets store beside their rows, numbered for each kind. Predicates that need the same values of a kind
// share them.
#pragma once
#include "gen/target/cpp/predicate.hpp"

namespace meetc::target {

struct stored_numbers {
  std::map<const lower::kernel *, std::array<int, 2>> of; // by predicate and operand; -1: nothing is stored
  std::map<std::string, int> count;                       // by kind: the number of different sets of stored values
};
stored_numbers number_stored(const unit &u);

} // namespace meetc::target
