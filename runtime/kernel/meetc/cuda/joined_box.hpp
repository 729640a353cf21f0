// The box around many boxes, which threads join by integer maxima.
#ifndef MEETC_CUDA_JOINED_BOX_HPP
#define MEETC_CUDA_JOINED_BOX_HPP

#include <meetc/cuda/table.hpp>
#include <meetc/volume/tree.hpp>

#include <cstring>

namespace meetc::cuda {

MEETC_HD inline std::uint32_t above_of(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b >> 31 ? ~b : b | 0x80000000U; // in the order of the numbers; no finite one is 0
}
MEETC_HD inline std::uint32_t below_of(float x) {
  return above_of(-x);
}
MEETC_HD inline float from_above(std::uint32_t bits) {
  const std::uint32_t b = bits >> 31 ? bits & 0x7fffffffU : ~bits;
  float x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}
MEETC_HD inline tree_box box_of(const joined_box &of) {
  tree_box b; // empty
  for (int k = 0; k < 3 && of.above[k] != 0; ++k)
    b.low[k] = -from_above(of.below[k]), b.high[k] = from_above(of.above[k]);
  return b;
}
// The common part of both; low > high on some axis if it is empty.
MEETC_HD inline tree_box common_box(const joined_box &a, const joined_box &b) {
  const tree_box x = box_of(a), y = box_of(b);
  tree_box c;
  for (int k = 0; k < 3; ++k) {
    c.low[k] = x.low[k] > y.low[k] ? x.low[k] : y.low[k];
    c.high[k] = x.high[k] < y.high[k] ? x.high[k] : y.high[k];
  }
  return c;
}

} // namespace meetc::cuda

#endif
