#include "core/device/kernels.hpp"

#include <cub/cub.cuh>

namespace meetc {
namespace {

constexpr unsigned threads = 256;
unsigned blocks_for(std::size_t n) {
  const std::size_t blocks = (n + threads - 1) / threads;
  return static_cast<unsigned>(blocks < 65536 ? blocks : 65536);
}

__global__ void keys_kernel(const index_pair *slots, std::size_t n, const std::uint32_t *order_a,
                            const std::uint32_t *owner_a, const std::uint32_t *order_b, const std::uint32_t *owner_b,
                            std::uint64_t *keys) {
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    std::uint32_t a = order_a[slots[i].a], b = order_b[slots[i].b];
    a = owner_a ? owner_a[a] : a;
    b = owner_b ? owner_b[b] : b;
    keys[i] = static_cast<std::uint64_t>(a) << 32 | b;
  }
}

__global__ void pairs_kernel(std::uint64_t *keys, std::size_t n) {
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    keys[i] = keys[i] >> 32 | keys[i] << 32;
}

__global__ void reaches_kernel(const float *rows, std::size_t numbers, unsigned fields, std::uint64_t lengths,
                               unsigned *most) {
  unsigned of[2] = {0, 0}; // magnitudes, whose order is that of their bits
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < numbers;
       i += gridDim.x * std::size_t{threads}) {
    const unsigned bits = __float_as_uint(rows[i]) & 0x7fffffff;
    const bool length = (lengths >> i % fields & 1) != 0;
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

cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(most, 0, 2 * sizeof(float), stream);
  if (e != cudaSuccess || n == 0)
    return e;
  reaches_kernel<<<blocks_for(n * fields), threads, 0, stream>>>(rows, n * fields, fields, lengths,
                                                                 reinterpret_cast<unsigned *>(most));
  return cudaGetLastError();
}

cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys,
                    cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  keys_kernel<<<blocks_for(n), threads, 0, stream>>>(slots, n, order_a, owner_a, order_b, owner_b, keys);
  return cudaGetLastError();
}

cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, cudaStream_t stream) {
  static_assert(sizeof(index_pair) == sizeof(std::uint64_t));
  if (n == 0)
    return cudaSuccess;
  pairs_kernel<<<blocks_for(n), threads, 0, stream>>>(keys, n);
  return cudaGetLastError();
}

cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream) {
  return cub::DeviceRadixSort::SortKeys(space, bytes, keys, to, n, 0, bits, stream);
}

cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream) {
  return cub::DeviceSelect::Unique(space, bytes, keys, to, kept, static_cast<std::int64_t>(n), stream);
}

} // namespace meetc
