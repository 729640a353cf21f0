#include "meet/core/device/set/order_kernels.hpp"

#include "meet/core/device/memory/blocks.hpp"

#include <cub/cub.cuh>
#include <meetc/cuda/launch.hpp>

namespace meetc {
namespace {

__global__ void reaches_kernel(const float *rows, std::size_t numbers, unsigned fields, std::uint64_t lengths,
                               unsigned *most) {
  unsigned of[2] = {0, 0}; // magnitudes, whose order is that of their bits
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < numbers;
       i += gridDim.x * std::size_t{threads}) {
    const unsigned bits = __float_as_uint(rows[i]) & 0x7fffffff;
    const auto field = static_cast<unsigned>(i % fields);
    const bool length = field < 64 && (lengths >> field & 1) != 0;
    of[length] = bits > of[length] ? bits : of[length];
  }
  for (int k = 0; k < 2; ++k) {
    unsigned warp = of[k];
    for (int d = 16; d > 0; d /= 2)
      warp = max(warp, __shfl_xor_sync(~0U, warp, d));
    if (threadIdx.x % 32 == 0)
      atomicMax(most + k, warp);
  }
}

} // namespace

cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        const std::uint32_t *numbers, std::uint32_t *slots, std::uint32_t n, int bits,
                        cudaStream_t stream) {
  return cub::DeviceRadixSort::SortPairs(space, bytes, places, sorted, numbers, slots, static_cast<std::int64_t>(n), 0,
                                         bits, stream);
}

cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(most, 0, 2 * sizeof(float), stream);
  if (e != cudaSuccess || n == 0)
    return e;
  return cuda::launch_after<reaches_kernel>(blocks_for(n * fields), threads, stream, rows, n * fields, fields, lengths,
                                            reinterpret_cast<unsigned *>(most));
}

} // namespace meetc
