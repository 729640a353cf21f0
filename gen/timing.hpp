// A program that times the predicates and formulas of a generated namespace.
#pragma once
#include <string>

namespace meetc {

// Its source, to be linked with the namespace's objects. It decides random pairs in the scene's box, for each predicate by
// the first rung of `certified`, which leaves few of them unsure, or else by `tolerant`, `exact` or `fp32`, and evaluates
// each formula in float32 on columns of 4,096 random numbers that stay in the cache. It prints lines of a word, "predicate"
// or "formula", the nanoseconds of one pair or evaluation on one thread, and the name.
std::string timing_program(const std::string &space);

} // namespace meetc
