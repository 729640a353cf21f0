#include "meet/core/device/order_kernels.hpp"

#include <cub/cub.cuh>

namespace meetc {

cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        const std::uint32_t *numbers, std::uint32_t *slots, std::uint32_t n, int bits,
                        cudaStream_t stream) {
  return cub::DeviceRadixSort::SortPairs(space, bytes, places, sorted, numbers, slots, static_cast<std::int64_t>(n), 0,
                                         bits, stream);
}

} // namespace meetc
