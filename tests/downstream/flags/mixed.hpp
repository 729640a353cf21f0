// Two translation units of one program, with different flags, decide the same rows.
#pragma once

#include <cstddef>

long wrong_here(std::size_t n);  // in mixed.cpp
long wrong_there(std::size_t n); // in mixed_there.cpp
