// Every pair of two sets as a product of matrices, on a CUDA device, over the launchers of the target cuda.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

// Throws spec_error where no predicate of the algebra gives the form of touching balls.
std::vector<file> every_pair_files(const unit &u);

// Touching balls as a sum of products, with the margins of the filter; the unit has that form.
std::string ball_form_header(const unit &u);

} // namespace meetc::target
