#include "meet/core/device/walk/walk_kernels.hpp"
#include "meet/core/device/walk/warp_walk.hpp"

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/tree.hpp>

#include <algorithm>

namespace meetc {
namespace {

using namespace cuda;

// Blocks that a multiprocessor runs at once. With more of them a thread has too few registers.
constexpr unsigned walk_blocks(walk_by by) {
  return by == walk_by::boxes ? 9 : by == walk_by::points ? 6 : 8;
}
// All warps of a block append together what is left at the end.
template <walk_by By, bool BothWays>
__global__ void __launch_bounds__(walk_threads, walk_blocks(By))
    walk_kernel(const __grid_constant__ tree_walk w, const __grid_constant__ walk_plan plan) {
  begin();
  if (!w.is_to_be_done())
    return;
  __shared__ warp_room rooms[walk_warps];
  __shared__ unsigned left[walk_warps];
  __shared__ unsigned long long at;
  const unsigned warp = threadIdx.x / tree_width;
  warp_walk<By, BothWays> mine(w, plan, rooms[warp]);
  mine.run(blockIdx.x * walk_warps + warp, gridDim.x * walk_warps);
  left[warp] = mine.hits().entries();
  __syncthreads();
  unsigned all = 0, before = 0;
  for (unsigned i = 0; i < walk_warps; ++i)
    all += left[i], before += i < warp ? left[i] : 0;
  if (threadIdx.x == 0)
    at = all > 0 ? reserve(w, all) : 0;
  __syncthreads();
  mine.hits().flush(at + before);
}

template <walk_by By, bool BothWays> cudaError_t start_walk(const tree_walk &w, cudaStream_t stream) {
  const unsigned most = blocks_at_once<walk_kernel<By, BothWays>, walk_threads>();
  const walk_plan plan = plan_of(w, most * walk_warps);
  const unsigned blocks = std::min((plan.items + walk_warps - 1) / walk_warps, most);
  return launch<walk_kernel<By, BothWays>>(blocks, walk_threads, stream, w, plan);
}
template <walk_by By> cudaError_t start_walk(const tree_walk &w, cudaStream_t stream) {
  return w.out.both_ways ? start_walk<By, true>(w, stream) : start_walk<By, false>(w, stream);
}

} // namespace

cudaError_t walk(const tree_walk &w, cudaStream_t stream) {
  if (w.of.first_a >= w.of.end_a || w.of.first_b >= w.of.end_b)
    return cudaSuccess;
  if (w.rows)
    return w.out.both_ways || w.balls ? cudaErrorInvalidValue : start_walk<walk_by::points, false>(w, stream);
  return w.balls ? start_walk<walk_by::balls>(w, stream) : start_walk<walk_by::boxes>(w, stream);
}

} // namespace meetc
