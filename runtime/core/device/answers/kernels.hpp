// core/device/answers/kernels.hpp: the kernels of answers, which know no shapes. They only enqueue work.
#ifndef MEETC_CORE_DEVICE_ANSWERS_KERNELS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_KERNELS_HPP

#include "meetc/cuda/table.hpp"
#include "meetc/support.hpp"

#include <cuda_runtime_api.h>

namespace meetc::on_device {

// A pair as a number, item_a 2^bits_b + item_b, so that their order is the same. The shorter, the fewer steps to sort.
MEETC_HD inline std::uint64_t key_of(index_pair p, int bits_b) {
  return std::uint64_t{p.a} << bits_b | p.b;
}
MEETC_HD inline index_pair pair_of(std::uint64_t key, int bits_b) {
  return {static_cast<std::uint32_t>(key >> bits_b),
          static_cast<std::uint32_t>(key & ((std::uint64_t{1} << bits_b) - 1))};
}

// Turns pairs of slots into keys of items. owner_x null: each element is its own item.
cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, int bits_b, std::uint64_t *keys,
                    cudaStream_t stream);
// Turns keys back into pairs, in place.
cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, int bits_b, cudaStream_t stream);

// Puts hits into the order of their elements, which needs no number on the host. Elements are their own items.
struct hit_order {
  const index_pair *hits; // of slots
  const unsigned long long *count;
  unsigned long long capacity;
  const std::uint32_t *order_a, *order_b;
  std::uint32_t items_a, items_b;
  std::uint32_t *counted; // counted_to_distribute numbers, all 0 before and after
  std::uint64_t *by_cell; // room for `capacity`
  index_pair *sorted;     // likewise
  // 0 at first. Where too many are of items that are near each other, it becomes 1, and `sorted` means nothing.
  unsigned long long *unordered;
};
// Where there are more than `capacity`, it does nothing.
cudaError_t order_hits(const hit_order &o, cudaStream_t stream);

// Counts the hits of each item, or marks the items that have one. Null: of this set nothing is asked. Where of_instance > 0,
// B's items are instances of so many slots each.
struct hit_tally {
  const index_pair *hits; // of slots
  std::size_t n;
  const std::uint32_t *order_a = nullptr, *order_b = nullptr;
  unsigned long long *counts_a = nullptr, *counts_b = nullptr;
  std::uint8_t *flags_a = nullptr, *flags_b = nullptr; // both or none
  std::uint32_t of_instance = 0;
};
cudaError_t tally(const hit_tally &t, cudaStream_t stream);

// named[order_a[i]] = order_b[slots[i]] for n slots, or no_slot where slots[i] is that.
cudaError_t name_slots(const std::uint32_t *slots, std::uint32_t n, const std::uint32_t *order_a,
                       const std::uint32_t *order_b, std::uint32_t *named, cudaStream_t stream);

// Adds `by` to the elements of n pairs.
cudaError_t renumber(index_pair *pairs, std::size_t n, index_pair by, cudaStream_t stream);

// Sorts keys below 2^bits into `to`. With space null, only sets the number of bytes that it needs.
cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream);
// Drops repeats of sorted keys; *kept, device memory, becomes the number of keys left.
cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream);

} // namespace meetc::on_device

#endif
