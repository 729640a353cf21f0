#include "meet/core/device/query/slots.hpp"

#include "meet/core/device/memory/blocks.hpp"

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>

namespace meetc::on_device {
namespace {

__global__ void slots_kernel(const std::uint32_t *order, std::uint32_t n, std::uint32_t *slot_of) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    slot_of[order[i]] = static_cast<std::uint32_t>(i);
}

__device__ std::uint32_t slot(const slots_there &s, std::uint32_t element) {
  return element < s.numbers ? s.slot_of[element] : cuda::no_slot;
}

__global__ void rows_kernel(const index_pair *pairs, std::size_t n, slots_there a, slots_there b, std::uint32_t *rows,
                            unsigned long long *bad) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    const std::uint32_t at_a = slot(a, pairs[i].a), at_b = slot(b, pairs[i].b);
    if (at_a == cuda::no_slot || at_b == cuda::no_slot)
      atomicMin(bad, static_cast<unsigned long long>(i));
    rows[2 * i] = at_a == cuda::no_slot ? 0 : at_a;
    rows[2 * i + 1] = at_b == cuda::no_slot ? 0 : at_b;
  }
}

} // namespace

cudaError_t find_slots(const std::uint32_t *order, std::uint32_t n, std::uint32_t *slot_of, std::uint32_t numbers,
                       cudaStream_t stream) {
  if (numbers == 0)
    return cudaSuccess;
  const cudaError_t cleared = cudaMemsetAsync(slot_of, 0xff, numbers * sizeof *slot_of, stream);
  if (cleared != cudaSuccess || n == 0)
    return cleared;
  return cuda::launch<slots_kernel>(blocks_for(n), threads, stream, order, n, slot_of);
}

cudaError_t rows_of_pairs(const index_pair *pairs, std::size_t n, slots_there a, slots_there b, std::uint32_t *rows,
                          unsigned long long *bad, cudaStream_t stream) {
  return n == 0 ? cudaSuccess : cuda::launch<rows_kernel>(blocks_for(n), threads, stream, pairs, n, a, b, rows, bad);
}

} // namespace meetc::on_device
