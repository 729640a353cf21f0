// Relations of two closed convex bodies beside touching, from exact distances.
#ifndef MEETC_GEN_ORACLE_BODIES_HPP
#define MEETC_GEN_ORACLE_BODIES_HPP

#include "gen/oracle/convex.hpp"

#include <cstddef>

namespace meetc::oracle {

// All points within `pad` of the hull, in a space of so many dimensions (2 or 3).
struct body {
  hull points;
  rational pad;
  std::size_t dimensions;
};

// Whether the hulls share a point that is not in the hull of `common`, which lies in both (none: any point).
[[nodiscard]] bool meets_beyond(const hull &a, const hull &b, const hull &common);

// Whether the interiors meet. Bodies without an interior, such as triangles, overlap if they touch and still do so after
// every translation that is short enough: a triangle and a segment that passes through its inside, but not two triangles
// in one plane.
[[nodiscard]] bool overlaps(const body &a, const body &b);

// Whether a holds all of b.
[[nodiscard]] bool contains(const body &a, const body &b);

} // namespace meetc::oracle

#endif
