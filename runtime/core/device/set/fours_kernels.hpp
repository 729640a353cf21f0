// core/device/set/fours_kernels.hpp: the kernel of hierarchies by fours, which depends on no kind of element. It is only
// enqueued.
#ifndef MEETC_CORE_DEVICE_SET_FOURS_KERNELS_HPP
#define MEETC_CORE_DEVICE_SET_FOURS_KERNELS_HPP

#include "meetc/cuda/table.hpp"
#include "meetc/volume/fours.hpp"

namespace meetc {

// Fills the nodes over the elements of a tree; there is room for shape.nodes() of them.
cudaError_t make_fours(const cuda::tree_node *elements, const cuda::fours_shape &shape, cuda::four_boxes *nodes,
                       cudaStream_t stream);

} // namespace meetc

#endif
