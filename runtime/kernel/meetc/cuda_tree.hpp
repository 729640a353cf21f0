// The spatial order and the lowest boxes of a set on the device, which depend on the kind of element. Included by nvcc only.
#ifndef MEETC_CUDA_TREE_HPP
#define MEETC_CUDA_TREE_HPP

#include <meetc/cuda_launch.hpp>
#include <meetc/cuda_table.hpp>
#include <meetc/cuda_warp.hpp>
#include <meetc/tree_order.hpp>

namespace meetc::cuda {

inline constexpr unsigned tree_threads = 128;

template <class Shape>
__global__ void __launch_bounds__(tree_threads)
    places_kernel(const float *rows, unsigned n, const extent *around, int bits, std::uint32_t *places) {
  begin();
  __shared__ hilbert_cells cells;
  if (threadIdx.x == 0)
    cells = hilbert_cells(*around, bits);
  __syncthreads();
  const unsigned i = blockIdx.x * tree_threads + threadIdx.x;
  if (i < n)
    places[i] = cells.place_of(box_of_row<Shape>(rows + i * std::size_t{Shape::fields}));
}
template <class Shape>
cudaError_t places(const float *rows, std::uint32_t n, const extent *around, int bits, std::uint32_t *places,
                   cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  return launch<places_kernel<Shape>>((n - 1) / tree_threads + 1, tree_threads, stream, rows, n, around, bits, places);
}

// A block has a warp for each child of a node of `level`, its own, where there is one. Each brings the box around its child,
// which goes there, and the box around all to the level above, if there is one. Its empty lanes are written too.
inline constexpr unsigned node_threads = tree_width * tree_width;
__device__ inline void put_above(tree_node *nodes, const tree_shape &shape, int level, const tree_box &child) {
  __shared__ tree_box children[tree_width];
  const unsigned node = blockIdx.x, warp = threadIdx.x / tree_width, lane = threadIdx.x % tree_width;
  if (lane == 0 && node < shape.count[level])
    put_box(nodes[shape.first[level] + node], warp, child);
  if (level + 1 == shape.depth)
    return;
  if (lane == 0)
    children[warp] = child;
  __syncthreads();
  if (warp > 0)
    return;
  const tree_box all = around_warp(children[lane]);
  if (lane == 0)
    put_box(nodes[shape.first[level + 1] + node / tree_width], node % tree_width, all);
}
// As many blocks as that takes.
inline unsigned blocks_above(const tree_shape &shape, int level) {
  return level + 1 == shape.depth ? shape.count[level] : shape.count[level + 1] * tree_width;
}

// A warp makes a node of level 0, and its box in level 1; and large blocks those of level 2.
template <class Shape, unsigned Threads>
__global__ void __launch_bounds__(Threads)
    boxes_kernel(const float *rows, unsigned n, tree_node *nodes, tree_shape shape) {
  begin();
  const unsigned node = (blockIdx.x * Threads + threadIdx.x) / tree_width, lane = threadIdx.x % tree_width;
  const std::size_t at = std::size_t{node} * tree_width + lane;
  tree_box b;
  if (at < n)
    b = box_of_row<Shape>(rows + at * std::size_t{Shape::fields});
  if (node < shape.count[0])
    put_box(nodes[node], lane, b);
  b = around_warp(b);
  if constexpr (Threads == node_threads)
    put_above(nodes, shape, 1, b);
  else if (lane == 0)
    put_box(nodes[shape.first[1] + node / tree_width], node % tree_width, b);
}
template <class Shape> cudaError_t boxes(const float *rows, std::uint32_t n, tree_node *nodes, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const tree_shape shape(n);
  if (levels_with_boxes(n) == 3)
    return launch<boxes_kernel<Shape, node_threads>>(blocks_above(shape, 1), node_threads, stream, rows, n, nodes,
                                                     shape);
  return launch<boxes_kernel<Shape, tree_threads>>(shape.count[1] * (node_threads / tree_threads), tree_threads, stream,
                                                   rows, n, nodes, shape);
}

} // namespace meetc::cuda

#endif
