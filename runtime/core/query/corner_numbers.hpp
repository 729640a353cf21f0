// core/query/corner_numbers.hpp: which elements of a mesh have common corners.
//
// A prepared set has the coordinates of each corner, and not the vertex that it is. Here each corner gets a number again, 12
// bytes an element: corners have one number if they are one vertex, or, where they are merged, if their coordinates are equal
// (0 and -0 are). From the numbers follow, for each vertex, the elements around it.
#ifndef MEETC_CORE_QUERY_CORNER_NUMBERS_HPP
#define MEETC_CORE_QUERY_CORNER_NUMBERS_HPP

#include "meet/core/sets/element_set.hpp"

#include <array>
#include <span>
#include <vector>

namespace meetc {

// The numbers of the corners of the element in each slot.
using corner_numbers = std::vector<std::array<std::uint32_t, 3>>;

// The set is whole, of elements with three points, and was filled from this view. Throws std::out_of_range for an index that
// is not there.
corner_numbers numbers_of_corners(const element_set &set, const view &elements, bool merge, const execution &on);

// The slots around each number, ascending.
class corner_stars {
public:
  explicit corner_stars(const corner_numbers &corners, const execution &on);
  std::span<const std::uint32_t> of(std::uint32_t number) const {
    return std::span(slots_).subspan(begin_[number], begin_[number + std::size_t{1}] - begin_[number]);
  }

private:
  std::vector<std::uint32_t> begin_; // fewer than 2^32 corners
  std::vector<std::uint32_t> slots_;
};

} // namespace meetc

#endif
