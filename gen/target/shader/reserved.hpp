// The words that shaders reserve.
#pragma once
#include <string>

namespace meetc::target {

// Whether GLSL 4.6 or WGSL has this name as a keyword, a reserved word, a type, or a function that emitted code calls.
bool is_reserved_in_shaders(const std::string &name);

} // namespace meetc::target
