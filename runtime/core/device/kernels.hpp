// core/device/kernels.hpp: the device kernels of the engine itself, which know no shapes.
#ifndef MEETC_CORE_DEVICE_KERNELS_HPP
#define MEETC_CORE_DEVICE_KERNELS_HPP

#include "meetc/table.hpp"

#include <cuda_runtime_api.h>

namespace meetc {

// Turns pairs of slots into keys, item_a 2^32 + item_b, whose order is that of the pairs. owner_x null: each element is
// its own item.
cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys,
                    cudaStream_t stream);
// Turns keys back into pairs, in place.
cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, cudaStream_t stream);

// Sorts keys below 2^bits into `to`. With space null, only sets the number of bytes that it needs.
cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream);
// Drops repeats of sorted keys; *kept, device memory, becomes the number of keys left.
cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream);

// The largest magnitudes of the numbers of rows of `fields` floats, as float32: most[1] of those whose bit is set in
// `lengths`, and most[0] of the others. most is device memory.
cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t stream);

} // namespace meetc

#endif
