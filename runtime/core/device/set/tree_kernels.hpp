// core/device/set/tree_kernels.hpp: the kernel of hierarchies that depends on no kind of element. It is only enqueued.
#ifndef MEETC_CORE_DEVICE_SET_TREE_KERNELS_HPP
#define MEETC_CORE_DEVICE_SET_TREE_KERNELS_HPP

#include "meetc/cuda/table.hpp"

namespace meetc {

// Fills the levels above the first ones, of which `levels` are filled.
cudaError_t enclose_levels(cuda::tree_node *nodes, std::uint32_t elements, int levels, cudaStream_t stream);

} // namespace meetc

#endif
