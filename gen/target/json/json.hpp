#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

// One object: the operands, then a predicate's atoms by stage or a formula's blades and norm2 in the declared basis, as
// terms [coefficient, {name: exponent}] and also as sums of products.
std::string json(const unit &u, std::size_t kernel);

} // namespace meetc::target
