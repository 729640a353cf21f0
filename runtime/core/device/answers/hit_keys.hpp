// core/device/answers/hit_keys.hpp: a list of pairs of items, as numbers that are gathered part by part and sorted at the end.
//
// CUB sorts them, which takes any number of any numbers: what the kernel of hits does not take (order_hits()).
// Where the device lacks the memory for that, the host sorts.
#ifndef MEETC_CORE_DEVICE_ANSWERS_HIT_KEYS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_HIT_KEYS_HPP

#include "meet/core/device/answers/query_answer.hpp"
#include "meet/core/device/memory/memory.hpp"

#include <span>
#include <vector>

namespace meetc::on_device {

// All members enqueue their work on the device's stream and throw device_error.
class hit_keys {
public:
  // Owners: the item of each element; empty: each element is its own item.
  hit_keys(const queried_sets &sets, std::span<const std::uint32_t> owner_a, std::span<const std::uint32_t> owner_b);

  // Adds n hits, pairs of slots.
  void add(const index_pair *hits, std::size_t n);
  // Sorts the pairs, and drops repeats where there are owners, which waits. Marks the clock behind the last kernel.
  void sort();

  // After sort(): the number of pairs, and their list. That is on the device, or null where the host has sorted it.
  std::size_t size() const { return here_.empty() ? keys_ : here_.size(); }
  const index_pair *there() const;
  std::vector<index_pair> take_list();

private:
  struct side {
    const device_rows &set;
    device_memory<std::uint32_t> owners;
    int bits; // of the largest item's number
    side(const device_rows &of, std::span<const std::uint32_t> from, cudaStream_t stream);
  };
  void spill();
  bool sort_there();

  const device &on_;
  bool owned_;
  side a_, b_;
  std::size_t keys_ = 0;
  std::vector<index_pair> here_;
};

// Pairs from device memory.
std::vector<index_pair> download_pairs(const device &on, const index_pair *from, std::size_t n);
// Room for n pairs, in which nothing is kept.
void make_room(std::vector<index_pair> &pairs, std::size_t n);

} // namespace meetc::on_device

#endif
