// app/coarse_tolerance.hpp: whether a tolerance is so coarse that a query takes long, known before it starts.
#ifndef MEETC_APP_COARSE_TOLERANCE_HPP
#define MEETC_APP_COARSE_TOLERANCE_HPP

#include "app/collide_sets.hpp"
#include "io/element_set.hpp"

#include <cstdint>
#include <string>

namespace meetc::app {

// How many pairs of elements have their first points on one multiple of the grid, so that they touch once they are rounded.
// Not less than `enough` is as good as more.
std::uint64_t pairs_at_one_point(const io::element_set &a, const io::element_set &b, double grid, std::uint64_t enough);

// The warning for a query that will find so many pairs that it takes seconds; empty where it will not, or has no tolerance.
std::string tolerance_warning(const io::element_set &a, const io::element_set &b, const query &q);

} // namespace meetc::app

#endif
