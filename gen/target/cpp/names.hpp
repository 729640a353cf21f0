// Names in emitted C++.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <functional>
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
// Whether an element obeys its kind's rule, as C++ code that tests bits. `number` names a stored number.
std::string rule_test(const lower::element_rule &r, const std::function<std::string(int)> &number);

} // namespace meetc::target
