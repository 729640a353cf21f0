// core/view.hpp: elements where the caller has them, and the pose under which they are taken.
#ifndef MEETC_CORE_VIEW_HPP
#define MEETC_CORE_VIEW_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace meetc {

// Borrowed memory. With `index`, each element is kind->points indices into `vertices` points x, y, z;
// without, each is a row of kind->fields floats and `vertices` is not looked at. Any stride will do, also an
// odd one.
struct view {
  const float *data = nullptr;
  std::size_t vertices = 0;
  std::size_t stride_bytes = 0;
  const std::uint32_t *index = nullptr;
  std::size_t elements = 0;
};

// Row-major 3x4. A point becomes ((m0*x + m1*y) + m2*z) + m3 in fp64, in this order, without fma, rounded
// once to float32; lengths are multiplied by length_scale, which the caller takes from the similarity. A kind
// of the plane has no z: it counts as 0. The identity passes every bit through.
struct pose {
  double m[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  double length_scale = 1;

  bool identity() const;
};

// Whether a pose knows how to move every field: points are x, y, z (or x, y) one after the other, or lengths.
bool can_move(const kind_info &kind);

enum class fault_kind : std::uint8_t {
  none,
  index, // the index of point `field` lies beyond the vertices
  value, // the value of `field` is not finite
  moved, // finite as stored; the pose takes it beyond float32
  rule,  // the element breaks `rule` of its kind
};

struct fault {
  fault_kind kind = fault_kind::none;
  std::size_t element = 0;
  int field = 0;
  float value = 0;
  std::uint32_t index = 0;
  const char *rule = nullptr;

  explicit operator bool() const { return kind != fault_kind::none; }
};

// The first fault in element order. Allocates one row.
fault check(const view &elements, const kind_info &kind, const pose &at = {});

// One line without a full stop: "element 7: r is nan".
std::string describe(const fault &f, const kind_info &kind);

} // namespace meetc

#endif
