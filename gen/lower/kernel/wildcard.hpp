// Wildcards of a scene: meet(*, *) is the meet of every pair of kinds that has one.
#pragma once
#include "gen/lower/expand/model.hpp"

namespace meetc::lower {

// The kernels with each one that has wildcards replaced by one for each choice of kinds for which the value is defined and not
// always zero, in the order of the kinds. These are the scene's `kinds`, or those of the algebra that have a blade of their
// own. Throws spec_error where there is no such choice.
std::vector<lang::kernel_request> without_wildcards(const model &m, const lang::scene &s);

} // namespace meetc::lower
