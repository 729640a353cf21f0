// core/morton.hpp: a spatial order of boxes.
//
// Problem: neighbours in space should be neighbours in memory, whatever the range of the coordinates and however
// unevenly they are spread. Method: Morton codes of the box centres on a cubic grid of 1024^3 (Morton 1966), sorted. A
// run that shares a cell and is longer than a block gets a grid of its own, recursively. One element at 1e38 therefore
// costs one level, not the order of all others. Centres are fp64, in which no float32 range overflows or underflows.
// Ties keep the order of the elements, so the order depends on nothing but the boxes.
#ifndef MEETC_CORE_MORTON_HPP
#define MEETC_CORE_MORTON_HPP

#include "core/box.hpp"

#include <cstddef>

namespace meetc {

// Afterwards the low 32 bits of keys[i] are the element at position i. The boxes are sanitised; scratch has room for n.
void spatial_order(const box *boxes, std::size_t n, std::uint64_t *keys, std::uint64_t *scratch, int threads);

} // namespace meetc

#endif
