// Numbers and signs of many pairs at a time.
//
// Include this before any header of generated predicates: these call meetc::fma(), meetc::both() and their like with
// qualified names, which find only functions declared before them. If the functions for lanes are declared later, a
// general one may be found in their place.
#ifndef MEETC_SIMD_LANES_HPP
#define MEETC_SIMD_LANES_HPP

#include <meetc/simd/float_lanes.hpp>
#include <meetc/simd/lane_signs.hpp>
#include <meetc/simd/wide_lanes.hpp>

#endif
