// core/hierarchy/spatial_order.hpp: a spatial order of boxes.
//
// Problem: neighbours in space should be neighbours in memory, whatever the range of the coordinates and however unevenly they
// are spread. Method: the cells of the box centres on a cubic grid of 1024^3, in the order of Hilbert's curve. A run that
// shares a cell and is longer than a block gets a grid of its own, recursively. One element at 1e38 therefore costs one level,
// not the order of all others. Cells are computed in fp64, in which no float32 range overflows. The places are sorted by digits
// (core/threads/radix_sort.hpp), and the runs of a bucket get their grids on the thread that sorts it. Ties keep the order of
// the elements, so the order depends on nothing but the boxes.
#ifndef MEETC_CORE_HIERARCHY_SPATIAL_ORDER_HPP
#define MEETC_CORE_HIERARCHY_SPATIAL_ORDER_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/core/threads/threads.hpp"

#include <cstddef>

namespace meetc {

// The centre of a box, made finite.
struct centre {
  float at[3];

  explicit centre(const box &b) {
    constexpr float most = std::numeric_limits<float>::max();
    for (int k = 0; k < 3; ++k) {
      const float middle = b.lo[k] / 2 + b.hi[k] / 2, above = middle > -most ? middle : -most;
      at[k] = above < most ? above : most;
    }
  }
};

// The box around centres; at first it holds none.
struct centre_extent {
  float lo[3], hi[3];

  centre_extent() {
    std::fill_n(lo, 3, std::numeric_limits<float>::infinity());
    std::fill_n(hi, 3, -std::numeric_limits<float>::infinity());
  }
  void add(const centre &c) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = c.at[k] < lo[k] ? c.at[k] : lo[k];
      hi[k] = hi[k] < c.at[k] ? c.at[k] : hi[k];
    }
  }
  void add(const centre_extent &e) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], e.lo[k]);
      hi[k] = std::max(hi[k], e.hi[k]);
    }
  }
  // The longest side, in fp64, in which no difference overflows or underflows.
  double size() const {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, static_cast<double>(hi[k]) - static_cast<double>(lo[k]));
    return longest;
  }
};

// Afterwards the low 32 bits of keys[i] are the element at position i, of the n elements in the list, which ascend;
// null: of 0 to n-1. `all` is the extent of their centres, which are finite; scratch has room for n.
void spatial_order(const centre *centres, const std::uint32_t *list, const centre_extent &all, std::size_t n,
                   std::uint64_t *keys, std::uint64_t *scratch, const execution &on);

} // namespace meetc

#endif
