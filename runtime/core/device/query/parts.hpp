// core/device/query/parts.hpp: the parts into which a query is cut where a list is too short for all of it.
#ifndef MEETC_CORE_DEVICE_QUERY_PARTS_HPP
#define MEETC_CORE_DEVICE_QUERY_PARTS_HPP

#include "meetc/cuda/table.hpp"

#include <cstdint>
#include <utility>

namespace meetc {

// Twice the pairs of two nodes: even if all of them are found, both ways, the lists can hold them.
inline constexpr std::size_t least_capacity = std::size_t{2} * cuda::tree_width * cuda::tree_width;

inline std::uint64_t area(const cuda::part &p) {
  return std::uint64_t{p.end_a - p.first_a} * (p.end_b - p.first_b);
}
// The halves of A or of B, cut at a multiple of `unit` from the part's begin.
inline std::pair<cuda::part, cuda::part> halves(const cuda::part &p, bool of_a, std::uint32_t unit) {
  const auto middle = [unit](std::uint32_t from, std::uint32_t to) {
    return from + (to - from + unit - 1) / unit / 2 * unit;
  };
  cuda::part x = p, y = p;
  if (of_a)
    x.end_a = y.first_a = middle(p.first_a, p.end_a);
  else
    x.end_b = y.first_b = middle(p.first_b, p.end_b);
  return {x, y};
}
// Whether a walk is rather cut along A. It goes down from the root for every node of the walker, which is B where it is
// swapped, so that it is rather that side which is cut.
inline bool cuts_a(const cuda::part &p, bool swapped) {
  const std::uint64_t a = p.end_a - p.first_a, b = p.end_b - p.first_b;
  if (a == 1 || b == 1)
    return a > b;
  return swapped ? a > 4 * b : 4 * a > b;
}

} // namespace meetc

#endif
