// core/views/rows.hpp: turns a caller's view into packed rows of kind.fields floats, posed and checked.
#ifndef MEETC_CORE_VIEWS_ROWS_HPP
#define MEETC_CORE_VIEWS_ROWS_HPP

#include "meet/core/views/pose.hpp"
#include "meet/core/views/status.hpp"
#include "meet/core/views/view.hpp"

namespace meetc {

// The fault of a view of elements of this kind, whatever its numbers are; null: nothing. All else here takes views of
// which nothing is.
const char *wrong_with(const view &elements, const kind_info &kind);

// The same view, with its stride stated.
view with_stride(view elements, const kind_info &kind);

// The view's own numbers, where they are the rows already: packed, not indexed and not moved. Null elsewhere.
const float *rows_in_place(const view &elements, const kind_info &kind, const pose &at);

// Whether these rows are finite and obey the rule of the kind: ok or bad_value.
status check_rows(const kind_info &kind, const float *rows, std::size_t count);

// Writes the elements [begin, end) as rows, the first to out[0], and returns `end`, or the first of which an index lies beyond
// the vertices; it and what follows is not written. The pose must be movable(). With a list, for views without an index, they
// are list[begin] and so on.
std::size_t fetch(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
                  float *out, const std::uint32_t *list = nullptr);

// Writes the elements [begin, end) as rows, the first to out[0], and returns ok, or bad_index or bad_value if one of
// them is bad; nothing out of bounds is read. The pose and the list are as those of fetch().
status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out, const std::uint32_t *list = nullptr);

} // namespace meetc

#endif
