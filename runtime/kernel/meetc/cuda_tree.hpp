// The order and the lowest boxes of a hierarchy on the device, which depend on the kind of element. Included by nvcc only.
#ifndef MEETC_CUDA_TREE_HPP
#define MEETC_CUDA_TREE_HPP

#include <meetc/cuda_table.hpp>
#include <meetc/cuda_warp.hpp>
#include <meetc/tree_order.hpp>

namespace meetc::cuda {

inline constexpr unsigned tree_threads = 128;

// The rows are in some order, so that many neighbours have one place; a warp counts these by one addition.
template <class Shape>
__global__ void __launch_bounds__(tree_threads) places_kernel(const float *rows, unsigned n, const extent *around,
                                                              int bits, std::uint32_t *counts, place_rank *places) {
  __shared__ hilbert_cells cells;
  if (threadIdx.x == 0)
    cells = hilbert_cells(*around, bits);
  __syncthreads();
  const unsigned i = blockIdx.x * tree_threads + threadIdx.x, lane = threadIdx.x % tree_width;
  const bool there = i < n;
  const unsigned active = __ballot_sync(~0U, there);
  if (!there)
    return;
  const std::uint32_t place = cells.place_of(box_of_row<Shape>(rows + i * std::size_t{Shape::fields}));
  const unsigned alike = __match_any_sync(active, place), leader = __ffs(alike) - 1;
  std::uint32_t first = 0;
  if (lane == leader)
    first = atomicAdd(counts + place, __popc(alike));
  first = __shfl_sync(alike, first, leader);
  places[i] = {place, first + __popc(alike & ((1U << lane) - 1))};
}
template <class Shape>
cudaError_t places(const float *rows, std::uint32_t n, const extent *around, int bits, std::uint32_t *counts,
                   place_rank *places, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  places_kernel<Shape><<<(n - 1) / tree_threads + 1, tree_threads, 0, stream>>>(rows, n, around, bits, counts, places);
  return cudaGetLastError();
}

// A warp makes a node of level 0, and its box in level 1. The empty lanes of level 1 are written too.
template <class Shape>
__global__ void __launch_bounds__(tree_threads)
    boxes_kernel(const float *rows, unsigned n, const std::uint32_t *slots, tree_node *nodes, tree_shape shape) {
  const unsigned node = (blockIdx.x * tree_threads + threadIdx.x) / tree_width, lane = threadIdx.x % tree_width;
  const std::size_t at = std::size_t{node} * tree_width + lane;
  tree_box b;
  if (at < n)
    b = box_of_row<Shape>(rows + slots[at] * std::size_t{Shape::fields});
  if (node < shape.count[0])
    put_box(nodes[node], lane, b);
  b = around_warp(b);
  if (lane == 0)
    put_box(nodes[shape.first[1] + node / tree_width], node % tree_width, b);
}
template <class Shape>
cudaError_t boxes(const float *rows, std::uint32_t n, const std::uint32_t *slots, tree_node *nodes,
                  cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const tree_shape shape(n);
  boxes_kernel<Shape><<<shape.count[1] * (tree_width / (tree_threads / tree_width)), tree_threads, 0, stream>>>(
      rows, n, slots, nodes, shape);
  return cudaGetLastError();
}

} // namespace meetc::cuda

#endif
