#include "core/device/order_kernels.hpp"

#include "core/device/blocks.hpp"

#include <cub/cub.cuh>
#include <meetc/tree.hpp>

#include <algorithm>

namespace meetc {
namespace {

__global__ void count_up_kernel(std::uint32_t *slots, unsigned n) {
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    slots[i] = static_cast<std::uint32_t>(i);
}

__global__ void crowded_kernel(const std::uint32_t *sorted, unsigned n, unsigned long long *crowded) {
  unsigned mine = 0;
  for (std::size_t i = cuda::tree_width + blockIdx.x * std::size_t{threads} + threadIdx.x; i < n;
       i += gridDim.x * std::size_t{threads})
    mine += sorted[i] == sorted[i - cuda::tree_width];
  for (int d = 16; d > 0; d /= 2)
    mine += __shfl_xor_sync(~0U, mine, d);
  if (threadIdx.x % 32 == 0 && mine > 0)
    atomicAdd(crowded, static_cast<unsigned long long>(mine));
}

// A warp writes 32 rows in one piece.
__global__ void gather_kernel(const float *rows, unsigned fields, std::uint32_t *slots, std::uint32_t n,
                              const std::uint32_t *names, float *to) {
  const unsigned lane = threadIdx.x % 32;
  for (std::size_t base = blockIdx.x * std::size_t{threads} + threadIdx.x - lane; base < n;
       base += gridDim.x * std::size_t{threads}) {
    const std::uint32_t from = base + lane < n ? slots[base + lane] : 0,
                        here = n - base < 32 ? static_cast<std::uint32_t>(n - base) : 32;
    if (names && base + lane < n)
      slots[base + lane] = names[from];
    for (unsigned first = 0; first < here * fields; first += 32) {
      const unsigned k = first + lane, row = k / fields;
      const std::uint32_t of = __shfl_sync(~0U, from, row % 32);
      if (k < here * fields)
        to[base * fields + k] = rows[std::size_t{of} * fields + (k - row * fields)];
    }
  }
}

} // namespace

cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        std::uint32_t *slots, std::uint32_t n, int bits, cudaStream_t stream) {
  // The numbers of the elements lie at the head of the space.
  const std::size_t head = (n * sizeof(std::uint32_t) + 255) / 256 * 256;
  std::size_t rest = space ? bytes - head : 0;
  auto *const counted = static_cast<std::uint32_t *>(space);
  if (space && n > 0)
    count_up_kernel<<<blocks_for(n), threads, 0, stream>>>(counted, n);
  const cudaError_t e =
      cub::DeviceRadixSort::SortPairs(space ? static_cast<std::byte *>(space) + head : nullptr, rest, places, sorted,
                                      counted, slots, static_cast<std::int64_t>(n), 0, bits, stream);
  if (!space)
    bytes = head + rest;
  return e;
}

cudaError_t count_crowded(const std::uint32_t *sorted, std::uint32_t n, unsigned long long *crowded,
                          cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(crowded, 0, sizeof *crowded, stream);
  if (e != cudaSuccess || n <= cuda::tree_width)
    return e;
  crowded_kernel<<<std::min(blocks_for(n), 1024U), threads, 0, stream>>>(sorted, n, crowded);
  return cudaGetLastError();
}

cudaError_t gather_rows(const float *rows, unsigned fields, std::uint32_t *slots, std::uint32_t n,
                        const std::uint32_t *names, float *to, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  gather_kernel<<<blocks_for(n), threads, 0, stream>>>(rows, fields, slots, n, names, to);
  return cudaGetLastError();
}

} // namespace meetc
