#include "core/device/tree_kernels.hpp"
#include "core/device/warp_walk.hpp"

#include <cub/cub.cuh>
#include <meetc/cuda_tree.hpp>

#include <algorithm>

namespace meetc {
namespace {

using namespace cuda;

__global__ void __launch_bounds__(tree_threads) levels_kernel(tree_node *nodes, tree_shape shape, int level) {
  const unsigned node = (blockIdx.x * tree_threads + threadIdx.x) / tree_width, lane = threadIdx.x % tree_width;
  tree_box b;
  if (node < shape.count[level])
    b = box_of(nodes[shape.first[level] + node], lane);
  b = around_warp(b);
  if (lane == 0)
    put_box(nodes[shape.first[level + 1] + node / tree_width], node % tree_width, b);
}

__global__ void __launch_bounds__(tree_threads)
    slots_kernel(const std::uint32_t *starts, const place_rank *places, unsigned n, std::uint32_t *slots) {
  const unsigned i = blockIdx.x * tree_threads + threadIdx.x;
  if (i < n)
    slots[starts[places[i].place] + places[i].rank] = i;
}

template <bool ByPoints>
__global__ void __launch_bounds__(walk_threads, ByPoints ? 8 : 10)
    walk_kernel(const __grid_constant__ tree_walk w, const __grid_constant__ walk_plan plan) {
  __shared__ warp_room rooms[walk_warps];
  warp_walk<ByPoints>(w, plan, rooms[threadIdx.x / tree_width]).run();
}

} // namespace

cudaError_t order_slots(void *space, std::size_t &bytes, std::uint32_t *counts, std::uint32_t cells,
                        const place_rank *places, std::uint32_t n, std::uint32_t *slots, cudaStream_t stream) {
  const cudaError_t e =
      cub::DeviceScan::ExclusiveSum(space, bytes, counts, counts, static_cast<std::int64_t>(cells), stream);
  if (e != cudaSuccess || !space || n == 0)
    return e;
  slots_kernel<<<(n - 1) / tree_threads + 1, tree_threads, 0, stream>>>(counts, places, n, slots);
  return cudaGetLastError();
}

cudaError_t enclose_levels(tree_node *nodes, std::uint32_t elements, cudaStream_t stream) {
  const tree_shape shape(elements);
  for (int level = 1; level + 1 < shape.depth; ++level)
    levels_kernel<<<shape.count[level + 1] * (tree_width / walk_warps), tree_threads, 0, stream>>>(nodes, shape, level);
  return cudaGetLastError();
}

cudaError_t walk(const tree_walk &w, cudaStream_t stream) {
  if (w.of.first_a >= w.of.end_a || w.of.first_b >= w.of.end_b)
    return cudaSuccess;
  const walk_plan plan = plan_of(w);
  const unsigned blocks = std::min((plan.items + walk_warps - 1) / walk_warps, walk_blocks);
  if (w.rows)
    walk_kernel<true><<<blocks, walk_threads, 0, stream>>>(w, plan);
  else
    walk_kernel<false><<<blocks, walk_threads, 0, stream>>>(w, plan);
  return cudaGetLastError();
}

} // namespace meetc
