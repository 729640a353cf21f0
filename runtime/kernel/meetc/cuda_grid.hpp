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

// n <= 2^31 numbers that become the sums of those before each, below 2^32 in all. Each of some blocks, which run at once, sums a chunk, and
// tells the others its total. (Merrill and Garland, Single-pass parallel prefix scan with decoupled look-back, 2016; no block
// waits for a sum that waits for another.)
struct running_sums {
  std::uint32_t *numbers, n;
  unsigned long long *totals; // for each block, all 0 at first; clear() is called once all blocks have met
  unsigned block, blocks;     // this one, of so many, at most as many as the threads of one

  template <unsigned Threads> __device__ void sum(unsigned (&room)[Threads / 32]) const {
    const unsigned chunk = n / blocks + (n % blocks != 0), each = (chunk + Threads - 1) / Threads;
    const auto within = [&](unsigned i) { return min(block * chunk + min(i, chunk), n); }; // place i of the chunk
    const unsigned from = within(threadIdx.x * each), to = within((threadIdx.x + 1) * each);
    unsigned mine = 0;
    for (unsigned i = from; i < to; ++i)
      mine += numbers[i];
    unsigned all = 0, start = 0;
    unsigned before = sum_before<Threads>(mine, room, all);
    if (threadIdx.x == 0)
      static_cast<volatile unsigned long long *>(totals)[block] = is_there | all;
    sum_before<Threads>(threadIdx.x < block ? total_of(threadIdx.x) : 0, room, start);
    before += start;
    for (unsigned i = from; i < to; ++i) {
      const unsigned x = numbers[i];
      numbers[i] = before;
      before += x;
    }
  }
  __device__ void clear() const {
    if (threadIdx.x == 0)
      totals[block] = 0;
  }

private:
  static constexpr unsigned long long is_there = 1ULL << 63;

  __device__ unsigned total_of(unsigned other) const {
    unsigned long long total = 0;
    while (total == 0) // the number and that it is there arrive together
      total = static_cast<const volatile unsigned long long *>(totals)[other];
    return static_cast<unsigned>(total);
  }
};

} // namespace meetc::cuda

#endif
