// core/device/query/slots.hpp: from the caller's elements to the rows of a set in order. Kernels that know no shapes; they only
// enqueue work.
#ifndef MEETC_CORE_DEVICE_QUERY_SLOTS_HPP
#define MEETC_CORE_DEVICE_QUERY_SLOTS_HPP

#include "meetc/support.hpp"

#include <cstdint>
#include <cuda_runtime_api.h>

namespace meetc::on_device {

// slot_of[order[i]] = i for n slots. The elements' numbers are below `numbers`, and those that no slot has become no_slot.
cudaError_t find_slots(const std::uint32_t *order, std::uint32_t n, std::uint32_t *slot_of, std::uint32_t numbers,
                       cudaStream_t stream);

// The slots of a set's elements.
struct slots_there {
  const std::uint32_t *slot_of;
  std::uint32_t numbers;
};
// rows[2 i] and rows[2 i + 1] become the slots of pair i. *bad becomes the least i whose elements are not there; it is at least
// n before, and rows[2 i] means nothing then.
cudaError_t rows_of_pairs(const index_pair *pairs, std::size_t n, slots_there a, slots_there b, std::uint32_t *rows,
                          unsigned long long *bad, cudaStream_t stream);

} // namespace meetc::on_device

#endif
