// meetc/support.hpp: what every generated header includes.
//
// Signs, three-valued answers, the arithmetic of the rungs as far as most pairs take it, and the plain types by which
// generated code and a runtime communicate. For host and device, in C++20, with no dependency but a compiler.
#ifndef MEETC_SUPPORT_HPP
#define MEETC_SUPPORT_HPP

#if __cplusplus < 202002L
#error "meetc needs C++20: compile with -std=c++20"
#endif

#define MEETC_SUPPORT_VERSION 14

#include <meetc/entry.hpp>
#include <meetc/rounding.hpp>
#include <meetc/self_test.hpp>
#include <meetc/table.hpp>
#include <meetc/valid.hpp>

#endif
