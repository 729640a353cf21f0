// core/device/parts.hpp: the parts into which a query is cut where a list is too short for all of it.
#ifndef MEETC_CORE_DEVICE_PARTS_HPP
#define MEETC_CORE_DEVICE_PARTS_HPP

#include "core/device/search.hpp"
#include "meetc/cuda_table.hpp"

#include <algorithm>
#include <utility>

namespace meetc {

// What a search takes as one object, by which its parts are counted.
constexpr std::uint32_t object_size(search by) {
  return by == search::tree ? cuda::tree_width : by == search::groups ? cuda::group_size : 1;
}
// Parts begin at multiples of this many objects.
constexpr std::uint32_t step_of(search by) {
  return by == search::tree ? 1 : cuda::part_step;
}
constexpr std::size_t least_part(search by) {
  const std::size_t elements = std::size_t{step_of(by)} * object_size(by);
  return elements * elements;
}
// Even if every pair of the smallest part's objects is taken apart, the lists can hold them.
inline constexpr std::size_t least_capacity = std::max(least_part(search::groups), least_part(search::tree));

inline std::uint64_t area(const cuda::part &p) {
  return std::uint64_t{p.end_a - p.first_a} * (p.end_b - p.first_b);
}
// Whether A is cut. A walk goes down from the root for every node of the walker, which is B where it is swapped, so that it is
// rather that side which is cut.
inline bool cuts_a(const cuda::part &p, search by, bool swapped) {
  const std::uint64_t a = p.end_a - p.first_a, b = p.end_b - p.first_b;
  if (by != search::tree || a == 1 || b == 1)
    return a > b;
  return swapped ? a > 4 * b : 4 * a > b;
}
// The halves of one side, cut between whole blocks where it has several.
inline std::pair<cuda::part, cuda::part> halves(const cuda::part &p, search by, bool swapped) {
  const auto middle = [by](std::uint32_t from, std::uint32_t to) {
    const std::uint32_t unit = by != search::tree && to - from > matrix_block ? matrix_block : step_of(by);
    return from + (to - from + unit - 1) / unit / 2 * unit;
  };
  cuda::part x = p, y = p;
  if (cuts_a(p, by, swapped))
    x.end_a = y.first_a = middle(p.first_a, p.end_a);
  else
    x.end_b = y.first_b = middle(p.first_b, p.end_b);
  return {x, y};
}

} // namespace meetc

#endif
