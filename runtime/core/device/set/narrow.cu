#include "meet/core/device/set/narrow.hpp"

#include "meet/core/device/memory/blocks.hpp"

#include <meetc/cuda/launch.hpp>

namespace meetc::on_device {
namespace {

__global__ void narrow_kernel(const std::int64_t *wide, std::size_t n, std::uint32_t *narrow) {
  cuda::begin();
  constexpr std::uint32_t none = 0xffffffffU;
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    narrow[i] = wide[i] >= 0 && wide[i] < std::int64_t{none} ? static_cast<std::uint32_t>(wide[i]) : none;
}

} // namespace

cudaError_t narrow_indices(const std::int64_t *wide, std::size_t n, std::uint32_t *narrow, cudaStream_t stream) {
  return n == 0 ? cudaSuccess : cuda::launch<narrow_kernel>(blocks_for(n), threads, stream, wide, n, narrow);
}

} // namespace meetc::on_device
