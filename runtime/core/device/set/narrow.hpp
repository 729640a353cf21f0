// core/device/set/narrow.hpp: indices of 64 bits, as those of PyTorch, in 32.
#ifndef MEETC_CORE_DEVICE_SET_NARROW_HPP
#define MEETC_CORE_DEVICE_SET_NARROW_HPP

#include <cstddef>
#include <cstdint>
#include <cuda_runtime_api.h>

namespace meetc::on_device {

// Both in device memory. An index that 32 bits do not hold becomes 2^32 - 1, which no set has as a vertex.
cudaError_t narrow_indices(const std::int64_t *wide, std::size_t n, std::uint32_t *narrow, cudaStream_t stream);

} // namespace meetc::on_device

#endif
