#include "meet/core/device/set/cull_kernels.hpp"

#include <meetc/cuda/cull.hpp>

#include <algorithm>

namespace meetc {
namespace {

using namespace cuda;

// Calls take(set, i, point, there) for each vertex of both sets. The first blocks have those of set 0.
template <class Take> __device__ void each_vertex(const vertices_of_two &v, unsigned blocks_of_first, Take &&take) {
  constexpr unsigned together = 4; // whose memory is on its way at once
  const int set = blockIdx.x < blocks_of_first ? 0 : 1;
  const view vertices{v.of[set].data, v.of[set].stride_bytes, nullptr, 0, v.of[set].vertices};
  const std::size_t first = set == 0 ? blockIdx.x : blockIdx.x - blocks_of_first,
                    step = (set == 0 ? blocks_of_first : gridDim.x - blocks_of_first) * std::size_t{cull_threads};
  for (std::size_t i = first * cull_threads + threadIdx.x; i < vertices.elements; i += together * step) {
    float points[together][3];
    bool there[together];
#pragma unroll
    for (unsigned k = 0; k < together; ++k)
      if (const std::size_t at = i + k * step; at < vertices.elements)
        there[k] = posed_element<vertex_shape>(vertices, v.at[set], static_cast<std::uint32_t>(at), points[k]);
#pragma unroll
    for (unsigned k = 0; k < together; ++k)
      if (const std::size_t at = i + k * step; at < vertices.elements)
        take(set, at, points[k], there[k]);
  }
}

__global__ void __launch_bounds__(cull_threads)
    surround_vertices_kernel(const __grid_constant__ vertices_of_two v, unsigned blocks_of_first, joined_box *around) {
  begin();
  tree_box all; // empty
  each_vertex(v, blocks_of_first, [&](int, std::size_t, const float *point, bool there) {
    for (int k = 0; k < 3 && there; ++k) {
      all.low[k] = point[k] < all.low[k] ? point[k] : all.low[k];
      all.high[k] = point[k] > all.high[k] ? point[k] : all.high[k];
    }
  });
  join_boxes<cull_threads>(all, around + (blockIdx.x < blocks_of_first ? 0 : 1));
}

__global__ void __launch_bounds__(cull_threads)
    cells_kernel(const __grid_constant__ vertices_of_two v, unsigned blocks_of_first, const joined_box *around,
                 int bits, vertex_cells cells) {
  begin();
  __shared__ cull_grid grid;
  if (threadIdx.x == 0)
    grid = cull_grid(around[0], around[1], bits);
  __syncthreads();
  each_vertex(v, blocks_of_first, [&](int set, std::size_t i, const float *point, bool there) {
    cells.of[set][i] = there ? grid.cells_of(point).bits : no_cells;
  });
}

// Blocks for both sets, in the ratio of their vertices.
template <auto Kernel, class... Arguments>
cudaError_t launch_for_both(const vertices_of_two &v, cudaStream_t stream, const Arguments &...arguments) {
  const std::size_t n[2] = {v.of[0].vertices, v.of[1].vertices}, all = n[0] + n[1];
  if (all == 0)
    return cudaSuccess;
  const auto wanted = [](std::size_t vertices) { return (vertices + cull_threads - 1) / cull_threads; };
  const std::size_t most = blocks_at_once<Kernel, cull_threads>();
  std::size_t blocks[2] = {wanted(n[0]), wanted(n[1])};
  if (blocks[0] + blocks[1] > most)
    for (int s = 0; s < 2; ++s)
      blocks[s] = std::min(blocks[s], std::max<std::size_t>(1, most * n[s] / all));
  return launch<Kernel>(static_cast<unsigned>(blocks[0] + blocks[1]), cull_threads, stream, v,
                        static_cast<unsigned>(blocks[0]), arguments...);
}

} // namespace

cudaError_t surround_vertices(const vertices_of_two &v, joined_box *around, cudaStream_t stream) {
  return launch_for_both<surround_vertices_kernel>(v, stream, around);
}

cudaError_t find_cells(const vertices_of_two &v, const joined_box *around, int bits, const vertex_cells &cells,
                       cudaStream_t stream) {
  return launch_for_both<cells_kernel>(v, stream, around, bits, cells);
}

} // namespace meetc
