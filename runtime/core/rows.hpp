// core/rows.hpp: from a caller's view to packed rows of kind.fields floats, moved and checked on the way.
#ifndef MEETC_CORE_ROWS_HPP
#define MEETC_CORE_ROWS_HPP

#include "core/pose.hpp"
#include "core/status.hpp"
#include "core/view.hpp"

namespace meetc {

// Elements [begin, end) as rows, the first at out[0]. Stops at the first element that is not good, and then
// says bad_index or bad_value; nothing out of bounds is read. The pose must be one that can_move() allows.
status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out);

} // namespace meetc

#endif
