// core/device/kernels.hpp: what the engine itself runs on the device; no shapes.
#ifndef MEETC_CORE_DEVICE_KERNELS_HPP
#define MEETC_CORE_DEVICE_KERNELS_HPP

#include "meetc/table.hpp"

#include <cuda_runtime_api.h>

namespace meetc {

// Pairs of slots become keys, item_a 2^32 + item_b, whose order is that of the pairs. owner_x null: an element is its
// own item.
cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys,
                    cudaStream_t stream);
// And keys pairs, in place.
cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, cudaStream_t stream);

// Sorts keys below 2^bits into `to`; with space null, only tells how many bytes of it are needed.
cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream);
// Leaves out repeats of sorted keys; *kept, device memory, is how many are left.
cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream);

} // namespace meetc

#endif
