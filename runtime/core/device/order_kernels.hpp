// core/device/order_kernels.hpp: the kernels that order a set on a device and depend on no kind of element. They only enqueue
// work.
#ifndef MEETC_CORE_DEVICE_ORDER_KERNELS_HPP
#define MEETC_CORE_DEVICE_ORDER_KERNELS_HPP

#include <cuda_runtime_api.h>

#include <cstddef>
#include <cstdint>

namespace meetc {

// Sorts n elements by their places, which are below 2^bits; those with one place keep their order. slots[i] becomes the
// element at position i, and sorted[i] its place. With `space` null it only sets `bytes`.
cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        std::uint32_t *slots, std::uint32_t n, int bits, cudaStream_t stream);
// *crowded becomes the number of elements before which at least tree_width others have the same place.
cudaError_t count_crowded(const std::uint32_t *sorted, std::uint32_t n, unsigned long long *crowded,
                          cudaStream_t stream);
// Row i is written from row slots[i]. Then slots[i] becomes names[slots[i]], if there are names.
cudaError_t gather_rows(const float *rows, unsigned fields, std::uint32_t *slots, std::uint32_t n,
                        const std::uint32_t *names, float *to, cudaStream_t stream);

} // namespace meetc

#endif
