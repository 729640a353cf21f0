#include "meet/core/device/set/tree_kernels.hpp"

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/tree.hpp>

namespace meetc {
namespace {

using namespace cuda;

// Fills two levels above one.
__global__ void __launch_bounds__(node_threads) levels_kernel(tree_node *nodes, tree_shape shape, int level) {
  begin();
  const unsigned node = (blockIdx.x * node_threads + threadIdx.x) / tree_width, lane = threadIdx.x % tree_width;
  tree_box b;
  if (node < shape.count[level])
    b = box_of(nodes[shape.first[level] + node], lane);
  put_above(nodes, shape, level + 1, blockIdx.x, around_warp(b));
}

} // namespace

cudaError_t enclose_levels(tree_node *nodes, std::uint32_t elements, int levels, cudaStream_t stream) {
  const tree_shape shape(elements);
  cudaError_t e = cudaSuccess;
  for (int level = levels - 1; level + 1 < shape.depth && e == cudaSuccess; level += 2)
    e = launch<levels_kernel>(nodes_above(shape, level + 1), node_threads, stream, nodes, shape, level);
  return e;
}

} // namespace meetc
