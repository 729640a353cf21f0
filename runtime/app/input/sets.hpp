// app/input/sets.hpp: turns sets as they were read into views and prepared sets, which the core collides.
#ifndef MEETC_APP_INPUT_SETS_HPP
#define MEETC_APP_INPUT_SETS_HPP

#include "meet/core/query/collide.hpp"
#include "meet/io/elements/words.hpp"

namespace meetc::app {

using io::is_mesh;

// Packs the set's elements (not its items: a polygon is several triangles). The set's `owner` goes to collide_options,
// so that pairs are of items. `counterpart` and the errors are as in meetc::prepare; sets from io::read are
// always good. With a grid, all numbers are rounded to it (pose::grid); one that leaves float32 is an input_error.
prepared prepare(const io::element_set &set, int threads = 0, const prepared *counterpart = nullptr, double grid = 0);

} // namespace meetc::app

#endif
