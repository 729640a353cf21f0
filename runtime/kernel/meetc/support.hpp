// meetc/support.hpp: the one header that generated code includes.
//
// Signs, three-valued answers, the arithmetics and rungs of a decision, and the plain types through which generated
// code meets a runtime. Host and device, C++20, no dependency but a compiler.
#ifndef MEETC_SUPPORT_HPP
#define MEETC_SUPPORT_HPP

#define MEETC_SUPPORT_VERSION 3

#include <meetc/rungs.hpp>
#include <meetc/self_test.hpp>
#include <meetc/table.hpp>

#endif
