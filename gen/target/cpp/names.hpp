// Names in emitted C++.
#pragma once
#include "gen/lower/kernel.hpp"

#include <string>

namespace meetc::target {

// A spec's name as a C++ identifier that is neither a keyword nor a template parameter.
std::string identifier(const std::string &name);
// "c.x" with each part mangled.
std::string path_identifier(const std::string &path);
// The field of a blade: "e1_n", or "scalar".
std::string blade_field(const lower::basis_blade &b);
// The name of a kernel's function or struct.
std::string kernel_function(const lower::request &r);
// Whether a number obeys a kind's rule, as C++ code that tests its bits.
std::string rule_test(const lower::enclosure &e, const std::string &number);

} // namespace meetc::target
