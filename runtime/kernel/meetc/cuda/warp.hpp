// Functions of the lanes of a warp together. Included by nvcc, or behind a stand-in for a warp.
#ifndef MEETC_CUDA_WARP_HPP
#define MEETC_CUDA_WARP_HPP

#include <meetc/cuda/joined_box.hpp>

namespace meetc::cuda {

// Integers in the order of the numbers that have these bits, and back.
__device__ inline int in_float_order(int bits) {
  return bits ^ (bits >> 31 & 0x7fffffff);
}
// The box around those of all lanes of this warp.
__device__ inline tree_box around_warp(tree_box b) {
  for (int k = 0; k < 3; ++k) {
    b.low[k] = __int_as_float(in_float_order(__reduce_min_sync(~0U, in_float_order(__float_as_int(b.low[k])))));
    b.high[k] = __int_as_float(in_float_order(__reduce_max_sync(~0U, in_float_order(__float_as_int(b.high[k])))));
  }
  return b;
}

// The box around those of a block's threads, which all call it; the first warp gets it.
template <unsigned Threads> __device__ tree_box around_block(const tree_box &mine) {
  __shared__ tree_box of_warps[Threads / 32];
  const unsigned lane = threadIdx.x % 32;
  const tree_box warp = around_warp(mine);
  __syncthreads(); // of an earlier call nobody reads any more
  if (lane == 0)
    of_warps[threadIdx.x / 32] = warp;
  __syncthreads();
  return threadIdx.x < 32 ? around_warp(lane < Threads / 32 ? of_warps[lane] : tree_box()) : warp;
}

// Joins what a block has found. All of its threads call it.
template <unsigned Threads> __device__ void join_boxes(tree_box all, joined_box *around) {
  constexpr unsigned warps = Threads / 32;
  __shared__ std::uint32_t below[3][warps], above[3][warps];
  all = around_warp(all);
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32;
  if (lane < 3) {
    const bool some = all.low[lane] <= all.high[lane];
    below[lane][warp] = some ? below_of(all.low[lane]) : 0, above[lane][warp] = some ? above_of(all.high[lane]) : 0;
  }
  __syncthreads();
  if (threadIdx.x >= 6)
    return;
  const unsigned axis = threadIdx.x % 3;
  std::uint32_t most = 0;
  for (unsigned w = 0; w < warps; ++w) {
    const std::uint32_t of = threadIdx.x < 3 ? below[axis][w] : above[axis][w];
    most = of > most ? of : most;
  }
  if (most > 0)
    atomicMax(threadIdx.x < 3 ? around->below + axis : around->above + axis, most);
}

} // namespace meetc::cuda

#endif
