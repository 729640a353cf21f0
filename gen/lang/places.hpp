// Where an algebra lies that a scene or another algebra names.
#pragma once
#include "gen/support/source.hpp"

namespace meetc::lang {

// The file `name`: beside the file that names it, in a folder of `algebra_path`, or among the algebras that come with the
// program. Throws spec_error with the places where it is not.
std::string find_algebra(const location &named_at, const std::string &name,
                         const std::vector<std::string> &algebra_path);

} // namespace meetc::lang
