// What the lanes of a warp compute together. Included by nvcc, or behind a stand-in for a warp.
#ifndef MEETC_CUDA_WARP_HPP
#define MEETC_CUDA_WARP_HPP

#include <meetc/tree.hpp>

namespace meetc::cuda {

// The box around those of all lanes of this warp.
__device__ inline tree_box around_warp(tree_box b) {
  for (int d = 16; d > 0; d /= 2)
    for (int k = 0; k < 3; ++k) {
      const float low = __shfl_xor_sync(~0U, b.low[k], d), high = __shfl_xor_sync(~0U, b.high[k], d);
      b.low[k] = low < b.low[k] ? low : b.low[k];
      b.high[k] = b.high[k] < high ? high : b.high[k];
    }
  return b;
}

} // namespace meetc::cuda

#endif
