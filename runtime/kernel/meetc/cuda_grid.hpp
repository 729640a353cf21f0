// What all blocks of a kernel compute together, where they run at once (launch_together()). Included by nvcc, or behind a
// stand-in for a warp.
#ifndef MEETC_CUDA_GRID_HPP
#define MEETC_CUDA_GRID_HPP

#include <meetc/cuda_launch.hpp>

#if defined(__CUDACC__)
#include <cooperative_groups.h>
#endif

#include <cstdint>

namespace meetc::cuda {

// All threads of all blocks meet. What one wrote before, every one reads after.
__device__ inline void meet_grid() {
#if defined(__CUDACC__)
  if (gridDim.x > 1) {
    cooperative_groups::this_grid().sync();
    return;
  }
#endif
  __syncthreads();
}
__device__ inline unsigned grid_thread() {
  return blockIdx.x * blockDim.x + threadIdx.x;
}
__device__ inline unsigned grid_threads() {
  return gridDim.x * blockDim.x;
}

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

// n numbers that become the sums of those before each, chunk by chunk: a block a chunk, whose length is a power of two. Then
// starts() is made, in each block, and at() gives the sums over all.
struct running_sums {
  std::uint32_t *numbers, n;
  std::uint32_t *totals; // for each block

  // A function of the grid; the blocks are at most as many as the threads of one.
  __device__ unsigned shift() const {
    unsigned s = 0;
    while ((static_cast<unsigned long long>(gridDim.x) << s) < n)
      ++s;
    return s;
  }
  template <unsigned Threads> __device__ void sum_chunk(unsigned (&room)[Threads / 32]) const {
    const unsigned size = 1U << shift(), each = (size + Threads - 1) / Threads;
    const unsigned long long first = static_cast<unsigned long long>(blockIdx.x) * size;
    const auto within = [&](unsigned long long i) {
      return static_cast<unsigned>(
          min(first + min(i, static_cast<unsigned long long>(size)), static_cast<unsigned long long>(n)));
    };
    const unsigned from = within(static_cast<unsigned long long>(threadIdx.x) * each),
                   to = within((threadIdx.x + 1ULL) * each);
    unsigned mine = 0;
    for (unsigned i = from; i < to; ++i)
      mine += numbers[i];
    unsigned all = 0;
    unsigned before = sum_before<Threads>(mine, room, all);
    for (unsigned i = from; i < to; ++i) {
      const unsigned x = numbers[i];
      numbers[i] = before;
      before += x;
    }
    if (threadIdx.x == 0)
      totals[blockIdx.x] = all;
  }
  // Once the grid has met: starts[b] becomes the sum of all chunks before that of block b.
  template <unsigned Threads>
  __device__ void sum_totals(unsigned (&room)[Threads / 32], unsigned (&starts)[Threads]) const {
    unsigned all = 0;
    starts[threadIdx.x] = sum_before<Threads>(threadIdx.x < gridDim.x ? totals[threadIdx.x] : 0, room, all);
    __syncthreads();
  }
  __device__ std::uint32_t at(const unsigned *starts, unsigned shift, std::uint32_t i) const {
    return numbers[i] + starts[i >> shift];
  }
};

} // namespace meetc::cuda

#endif
