// core/views/check.hpp: finds the bad element in a caller's view and says what is wrong with it.
#ifndef MEETC_CORE_VIEWS_CHECK_HPP
#define MEETC_CORE_VIEWS_CHECK_HPP

#include "meet/core/views/pose.hpp"
#include "meet/core/views/view.hpp"

#include <string>

namespace meetc {

enum class fault_kind : std::uint8_t {
  none,
  view,    // `rule` says what is wrong with the view as a whole
  index,   // the index of point `field` lies beyond the vertices
  value,   // the value of `field` is not finite
  moved,   // finite as stored, but the pose takes it beyond float32
  rounded, // finite in its place, but its nearest multiple of the pose's grid lies beyond float32
  rule,    // the element breaks `rule` of its kind
  unheld,  // no float32 holds the given number, and `value` is the nearest one
};

struct fault {
  fault_kind kind = fault_kind::none;
  std::size_t element = 0;
  int field = 0;
  float value = 0;
  std::uint32_t index = 0;
  double grid = 0; // of `rounded`
  const char *rule = nullptr;

  explicit operator bool() const { return kind != fault_kind::none; }
};

// The fault of the view, or the first one in the order of elements. Allocates one row.
fault check(const view &elements, const kind_info &kind, const pose &at = {});

// One line without a full stop: "element 7: r is nan".
std::string describe(const fault &f, const kind_info &kind);

} // namespace meetc

#endif
