// The word that stands in the key `contacts` of a predicate in place of a function.
#pragma once

namespace meetc::lang {

// A runtime places one point of both operands.
inline constexpr const char *one_witness = "witness";

} // namespace meetc::lang
