// What sets store beside their rows, numbered by kind: predicates whose values of a kind are the same share them.
#pragma once
#include "gen/target/cpp/predicate.hpp"

namespace meetc::target {

struct stored_numbers {
  std::map<const lower::kernel *, std::array<int, 2>> of; // by predicate and operand; -1: nothing is stored
  std::map<std::string, int> count;                       // by kind: how many different ones a kind has
};
stored_numbers number_stored(const unit &u);

} // namespace meetc::target
