// app/query/coarse_tolerance.hpp: warns before a query whose tolerance is so coarse that it will take long.
#ifndef MEETC_APP_QUERY_COARSE_TOLERANCE_HPP
#define MEETC_APP_QUERY_COARSE_TOLERANCE_HPP

#include "meet/app/query/collide_sets.hpp"
#include "meet/io/elements/element_set.hpp"

#include <cstdint>
#include <string>

namespace meetc::app {

// The number of pairs of elements whose first points round to one point of the grid, so that they touch once rounded.
// Counting stops at `enough`: a result from there on means "at least so many".
std::uint64_t pairs_at_one_point(const io::element_set &a, const io::element_set &b, double grid, std::uint64_t enough);

// The warning for a query that will find so many pairs that it takes seconds. Empty for others, and without a
// tolerance.
std::string tolerance_warning(const io::element_set &a, const io::element_set &b, const query &q);

} // namespace meetc::app

#endif
