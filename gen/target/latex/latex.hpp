#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

// An align* environment: the atoms of a predicate, or the blades of a formula and B^2 in the declared basis.
std::string latex(const unit &u, std::size_t kernel);

} // namespace meetc::target
