// core/views/status.hpp: the outcome of a call that does not throw.
#ifndef MEETC_CORE_VIEWS_STATUS_HPP
#define MEETC_CORE_VIEWS_STATUS_HPP

#include <cstdint>

namespace meetc {

enum class status : std::uint8_t {
  ok,
  workspace_too_small, // call workspace() with the same arguments
  no_such_rung,        // the predicate was not generated for this rung
  too_many_elements,   // indices are 32-bit
  bad_index,           // check() names the element
  bad_value,           // not finite, perhaps only after the pose, or against a rule of the kind; check() names it
  cannot_move,         // the kind has fields that a pose cannot move
  turns_axes,          // the kind's edges lie along the axes, and the pose does not keep them there
  bad_grid,            // a pose's grid is no power of two
  not_on_grid,         // the rung tolerant is for sets that were rounded to its grid, by their poses
  left_box,            // the rung tolerant is for sets in its scene's box, and the scene has no certified rungs
  bad_view,            // null data, a stride shorter than a row, or an index into no points; check() says which
  bad_argument,        // count is null, pairs have room but no memory, or the box is negative
  cancelled,           // a stop was requested
};

// In words, without a full stop.
constexpr const char *text(status s) {
  switch (s) {
  case status::ok:
    return "ok";
  case status::workspace_too_small:
    return "the workspace is too small";
  case status::no_such_rung:
    return "the predicate was not generated for this rung";
  case status::too_many_elements:
    return "more than 2^32 - 1 elements";
  case status::bad_index:
    return "an index lies beyond the vertices";
  case status::bad_value:
    return "a value is not finite or breaks a rule of its kind";
  case status::cannot_move:
    return "this kind cannot be moved by a pose";
  case status::turns_axes:
    return "a pose does more than move and scale along the axes, and this kind has its edges there";
  case status::bad_grid:
    return "a pose's grid is neither 0 nor a power of two from 2^-149 to 2^127";
  case status::not_on_grid:
    return "the rung tolerant is for sets whose poses have its grid (predicate_info::tolerance.step)";
  case status::left_box:
    return "a set leaves the box for which the rung tolerant was generated";
  case status::bad_view:
    return "a view has null data, a stride shorter than a row, or an index although its kind is not made of points";
  case status::bad_argument:
    return "an argument is null that must not be, or the box is negative";
  case status::cancelled:
    return "cancelled";
  }
  return "unknown";
}

} // namespace meetc

#endif
