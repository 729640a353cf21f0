// meet/support.hpp: the one header that generated code includes.
//
// Signs, three-valued answers, the arithmetics and rungs of a decision, and the plain types through which generated
// code meets a runtime. Host and device, C++20, no dependency but a compiler.
#ifndef MEET_SUPPORT_HPP
#define MEET_SUPPORT_HPP

#define MEET_SUPPORT_VERSION 3

#include <meet/rungs.hpp>
#include <meet/self_test.hpp>
#include <meet/table.hpp>

#endif
