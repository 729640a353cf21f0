// The second evaluation for an algebra as the compiler reads it: in the working basis.
#pragma once
#include "gen/lower/expand/model.hpp"
#include "gen/verify/dense_evaluator.hpp"

namespace meetc::verify {

dense_evaluator dense_evaluator_of(const lower::model &m);

} // namespace meetc::verify
