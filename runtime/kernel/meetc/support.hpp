// meetc/support.hpp: the one header that generated code includes.
//
// Signs, three-valued answers, the arithmetics and rungs of a decision, and the plain types through which generated
// code meets a runtime. Host and device, C++20, no dependency but a compiler.
#ifndef MEETC_SUPPORT_HPP
#define MEETC_SUPPORT_HPP

#if __cplusplus < 202002L
#error "meetc needs C++20: compile with -std=c++20"
#endif

#define MEETC_SUPPORT_VERSION 4

#include <meetc/boxes.hpp>
#include <meetc/entry.hpp>
#include <meetc/self_test.hpp>
#include <meetc/table.hpp>
#include <meetc/valid.hpp>

#endif
