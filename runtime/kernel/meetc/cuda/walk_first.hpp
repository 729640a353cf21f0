// The kernel of a walk to what segments meet first. Included by nvcc only.
#ifndef MEETC_CUDA_WALK_FIRST_HPP
#define MEETC_CUDA_WALK_FIRST_HPP

#include <meetc/cuda/first_walk.hpp>
#include <meetc/cuda/steps.hpp>

namespace meetc::cuda {

inline constexpr unsigned first_walk_threads = 128, first_walk_blocks = 4; // that a multiprocessor runs at once

template <class P, class Decide>
__global__ void __launch_bounds__(first_walk_threads, first_walk_blocks)
    first_walk_kernel(const __grid_constant__ first_walk_job job) {
  begin();
  if (!job.is_to_be_done())
    return;
  constexpr unsigned warps = first_walk_threads / 32;
  __shared__ index_pair rooms[warps][first_walk_hits];
  const unsigned warp = threadIdx.x / 32;
  first_walk<P, Decide> mine(job, rooms[warp]);
  mine.run(blockIdx.x * warps + warp, gridDim.x * warps);
  mine.hits().template flush_block<warps>();
}
template <class P> cudaError_t walk_first(const first_walk_job &job, cudaStream_t stream) {
  constexpr auto kernel = first_walk_kernel<P, certify_step<P, in_fp32>>;
  if (job.of.first_a >= job.of.end_a || job.of.first_b >= job.of.end_b)
    return cudaSuccess;
  const unsigned most = blocks_at_once<kernel, first_walk_threads>(),
                 wanted = (job.of.end_a - job.of.first_a - 1) / first_walk_threads + 1;
  return launch<kernel>(wanted < most ? wanted : most, first_walk_threads, stream, job);
}

} // namespace meetc::cuda

#endif
