// core/device/set/order_kernels.hpp: the kernels that order and measure a set on a device and depend on no kind of element.
// They only enqueue work.
#ifndef MEETC_CORE_DEVICE_SET_ORDER_KERNELS_HPP
#define MEETC_CORE_DEVICE_SET_ORDER_KERNELS_HPP

#include <cuda_runtime_api.h>

#include <cstddef>
#include <cstdint>

namespace meetc {

// Sorts n elements by their places, which are below 2^bits; those with one place keep their order. slots[i] becomes the
// number of the element at position i, and sorted[i] its place. With `space` null it only sets `bytes`.
cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        const std::uint32_t *numbers, std::uint32_t *slots, std::uint32_t n, int bits,
                        cudaStream_t stream);

// The largest magnitudes of the numbers of rows of `fields` floats, as float32: most[1] of those whose bit is set in
// `lengths`, and most[0] of the others, among them all from the 64th on. most is device memory.
cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t stream);

} // namespace meetc

#endif
