#include "meet/core/device/set/tree.hpp"

#include "meet/core/device/set/tree_kernels.hpp"

namespace meetc {

void device_tree::make(const cuda::set_launchers &kind, const float *rows, std::uint32_t n, cudaStream_t stream) {
  nodes_.reserve(cuda::tree_shape(n).nodes(), "a hierarchy");
  check(kind.boxes(rows, n, nodes_.data(), arrived(stream), stream), "starting a kernel");
  check(enclose_levels(nodes_.data(), n, cuda::levels_with_boxes(n), stream), "starting a kernel");
}

unsigned *device_tree::arrived(cudaStream_t stream) {
  if (!arrived_.data()) {
    arrived_.reserve(1, "a hierarchy");
    check(cudaMemsetAsync(arrived_.data(), 0, sizeof(unsigned), stream), "making a hierarchy");
  }
  return arrived_.data();
}

} // namespace meetc
