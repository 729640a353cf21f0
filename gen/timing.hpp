// A program that times the predicates of a generated namespace.
#pragma once
#include <string>

namespace meetc {

// Its source, to be linked with the namespace's objects. It decides random pairs in the scene's box, for each predicate by
// the rung that is never wrong or, in a scene with a tolerance, keeps it, and prints the predicate's name and the
// nanoseconds of a pair.
std::string timing_program(const std::string &space);

} // namespace meetc
