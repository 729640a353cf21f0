// meetc/support.hpp: the one header that every generated header includes.
//
// Signs, three-valued answers, the arithmetic of the rungs that most pairs need, and the plain types in the interface
// of generated code and a runtime. For host and device, in C++20, with no dependency but a compiler.
#ifndef MEETC_SUPPORT_HPP
#define MEETC_SUPPORT_HPP

#if __cplusplus < 202002L
#error "meetc needs C++20: compile with -std=c++20"
#endif

#include <meetc/decide/entry.hpp>
#include <meetc/environment/valid.hpp>
#include <meetc/number/rounding.hpp>
#include <meetc/number/self_test.hpp>
#include <meetc/table/table.hpp>

#endif
