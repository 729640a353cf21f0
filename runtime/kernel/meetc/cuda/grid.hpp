// Functions of all blocks of a kernel together, where they run at once (launch_together()). Included by nvcc, or behind a
// stand-in for a warp.
#ifndef MEETC_CUDA_GRID_HPP
#define MEETC_CUDA_GRID_HPP

#include <meetc/cuda/launch.hpp>

#if defined(__CUDACC__)
#include <cooperative_groups.h>
#endif

#include <cstdint>

namespace meetc::cuda {

#if defined(__CUDACC__)
// All threads of all blocks meet. Each reads afterwards all that any of them wrote before.
__device__ inline void meet_grid() {
  cooperative_groups::this_grid().sync();
}
#endif

__device__ inline unsigned sum_up_to(unsigned mine) { // in this lane of a warp
  for (unsigned d = 1; d < 32; d *= 2) {
    const unsigned below = __shfl_up_sync(~0U, mine, d);
    mine += threadIdx.x % 32 >= d ? below : 0;
  }
  return mine;
}
// The sum of what the threads before this one bring; `all` becomes that of the whole block, whose threads all call it.
template <unsigned Threads>
__device__ unsigned sum_before(unsigned mine, unsigned (&room)[Threads / 32], unsigned &all) {
  static_assert(Threads <= 1024);
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32, up_to = sum_up_to(mine);
  __syncthreads(); // of an earlier call nobody reads any more
  if (lane == 31)
    room[warp] = up_to;
  __syncthreads();
  const unsigned warps_up_to = sum_up_to(lane < Threads / 32 ? room[lane] : 0);
  all = __shfl_sync(~0U, warps_up_to, 31);
  const unsigned warps_before = __shfl_sync(~0U, warps_up_to, warp > 0 ? warp - 1 : 0);
  return (warp > 0 ? warps_before : 0) + up_to - mine;
}

} // namespace meetc::cuda

#endif
