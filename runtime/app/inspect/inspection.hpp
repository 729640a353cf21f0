// app/inspect/inspection.hpp: the properties of a set of elements: its box, its grid and its degenerate elements.
//
// All of them are exact: a triangle has zero area where its corners, as rational numbers, are collinear. This is tested
// in integers on the grid of its own coordinates.
#ifndef MEETC_APP_INSPECT_INSPECTION_HPP
#define MEETC_APP_INSPECT_INSPECTION_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/io/elements/element_set.hpp"

#include <cmath>
#include <optional>

namespace meetc::app {

struct inspection {
  box points{{1, 1, 1}, {-1, -1, -1}}; // around all points (without radii); lo > hi where there are none
  box bounds{{1, 1, 1}, {-1, -1, -1}}; // around all elements
  grid numbers{1000, -1000};           // of every number of every element
  double reach = 0;                    // the largest |coordinate|, or half of the largest length
  // The least of the triangles' heights, the segments' lengths or the radii that are not 0, rounded in double; infinite
  // where there is none.
  double least_size = HUGE_VAL;
  std::size_t zero_area = 0; // items, as in the next three
  std::size_t zero_length = 0;
  std::size_t zero_radius = 0;
  std::size_t flat = 0;            // boxes with a side of length 0
  std::size_t duplicates = 0;      // items that repeat an earlier one, with the corners in any order
  std::size_t unused_vertices = 0; // in an indexed mesh
};

inspection inspection_of(const io::element_set &set);

// The number of bits that the differences of two coordinates can span, in steps of the grid: the least n with every
// |difference| <= 2^n steps. None if there are no points.
std::optional<int> difference_bits(const box &points, const grid &numbers);

// The least power of two b with every coordinate in [-b, b] and every length in [0, 2 b]; 0 if all numbers are 0, or if
// b is not a float32.
double box_for(const inspection &x, const inspection &y);

box around(const box &x, const box &y);
grid around(const grid &x, const grid &y);

} // namespace meetc::app

#endif
