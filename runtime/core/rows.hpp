// core/rows.hpp: turns a caller's view into packed rows of kind.fields floats, posed and checked.
#ifndef MEETC_CORE_ROWS_HPP
#define MEETC_CORE_ROWS_HPP

#include "core/pose.hpp"
#include "core/status.hpp"
#include "core/view.hpp"

namespace meetc {

// Writes the elements [begin, end) as rows, the first to out[0]. Stops at the first bad element and returns bad_index
// or bad_value; nothing out of bounds is read. The kind must pass can_move() unless the pose is the identity.
status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out);

} // namespace meetc

#endif
