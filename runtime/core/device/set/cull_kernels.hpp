// core/device/set/cull_kernels.hpp: the kernels that cull two sets and depend on no kind of element. They only enqueue work.
#ifndef MEETC_CORE_DEVICE_SET_CULL_KERNELS_HPP
#define MEETC_CORE_DEVICE_SET_CULL_KERNELS_HPP

#include "meetc/cuda/table.hpp"

namespace meetc {

// The vertices of two sets, of which either may have none.
struct vertices_of_two {
  cuda::view of[2];
  cuda::pose_matrix at[2];
};
// Widens around[i] by those of set i that are finite in their pose: those that no element names, too.
cudaError_t surround_vertices(const vertices_of_two &v, cuda::joined_box *around, cudaStream_t stream);
// Writes the packed cells of each vertex of set i to cells[i], or no_cells where it is not finite in its pose.
struct vertex_cells {
  std::uint32_t *of[2];
};
cudaError_t find_cells(const vertices_of_two &v, const cuda::joined_box *around, int bits, const vertex_cells &cells,
                       cudaStream_t stream);

} // namespace meetc

#endif
