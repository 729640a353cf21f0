#include "meet/core/device/set/fours.hpp"

#include "meet/core/device/set/fours_kernels.hpp"

namespace meetc {

std::optional<cuda::fours_view> device_fours::make(const cuda::tree_view &tree, cudaStream_t stream) {
  if (tree.elements == 0 || tree.elements > cuda::most_in_fours)
    return {};
  const cuda::fours_shape shape(tree.elements);
  if (!nodes_.grow(shape.nodes(), 0, stream))
    return {};
  check(make_fours(tree.nodes, shape, nodes_.data(), stream), "starting a kernel");
  return cuda::fours_view{nodes_.data(), shape};
}

} // namespace meetc
