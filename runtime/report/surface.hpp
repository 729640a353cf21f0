// report/surface.hpp: the faces of a mesh that no listed pair names, with positions of 16 bits.
//
// Faces are ordered along Hilbert's curve, those that are hit behind the others, and points are numbered as the faces name
// them, so that differences between points, and between the numbers in faces, are small. Points that are one after rounding
// are one point. Each coordinate is within half a step of the mesh's.
#ifndef MEETC_REPORT_SURFACE_HPP
#define MEETC_REPORT_SURFACE_HPP

#include "meet/picture/scene.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meetc::report {

struct surface {
  std::array<double, 3> lo = {}, step = {}; // coordinate = lo + step * number
  std::vector<std::array<std::uint16_t, 3>> points;
  std::vector<std::uint32_t> index; // three for each face
  std::size_t hits = 0;             // the number of faces that are hit, which come last
};

// The corner of a triangle, as it stands in the shape's rows.
inline const float *corner(const picture::shape &s, std::size_t face, std::size_t k) {
  const std::size_t at = 3 * face + k;
  return s.rows.data() + 3 * (s.index.empty() ? at : s.index[at]);
}

inline bool is_hit(const picture::shape &s, std::size_t element) {
  return element < s.hit.size() && s.hit[element] != 0;
}

// left_out: 1 for each triangle that is not to be in it.
surface surface_of(const picture::shape &mesh, std::span<const std::uint8_t> left_out);

} // namespace meetc::report

#endif
