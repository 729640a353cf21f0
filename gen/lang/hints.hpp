// Replacements for the words and signs of other languages, as the end of a message. Empty where nothing is known.
#pragma once
#include "gen/lang/spec.hpp"

namespace meetc::lang {

std::string hint_for_symbol(const std::string &symbol); // "; write '^' for the outer product"
std::string hint_for_function(const std::string &name); // "; write '^' for the outer product", for wedge
std::string hint_for_name(const algebra &a,
                          const std::string &name); // of a basis blade with a vector that is not there

} // namespace meetc::lang
