#include "meet/core/device/set/fours_kernels.hpp"

#include <meetc/cuda/launch.hpp>

namespace meetc {
namespace {

using namespace cuda;

constexpr unsigned fours_threads = 128;

// A thread makes a node of the level.
__global__ void __launch_bounds__(fours_threads)
    fours_kernel(const tree_node *elements, fours_shape shape, int level, four_boxes *nodes) {
  begin();
  const std::uint32_t q = blockIdx.x * fours_threads + threadIdx.x;
  if (q < shape.count(level))
    nodes[fours_shape::first(level) + q] = made_node(shape, level, q, elements, nodes);
}

} // namespace

cudaError_t make_fours(const tree_node *elements, const fours_shape &shape, four_boxes *nodes, cudaStream_t stream) {
  cudaError_t e = cudaSuccess;
  for (int level = shape.depth - 1; level >= 0 && e == cudaSuccess; --level)
    e = launch<fours_kernel>((shape.count(level) - 1) / fours_threads + 1, fours_threads, stream, elements, shape,
                             level, nodes);
  return e;
}

} // namespace meetc
