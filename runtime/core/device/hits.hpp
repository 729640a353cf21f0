// core/device/hits.hpp: what a query has found, from its kernels' list of hits to sorted pairs of items.
//
// The hits of a whole query are put into order by one kernel, which needs no number on the host, or else gathered as keys, part
// by part, which are sorted at the end. Where the device lacks the memory for that, the host sorts.
#ifndef MEETC_CORE_DEVICE_HITS_HPP
#define MEETC_CORE_DEVICE_HITS_HPP

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/kernels.hpp"
#include "meet/core/device/query.hpp"
#include "meet/core/device/set.hpp"
#include "meetc/cuda/table.hpp"

#include <functional>
#include <span>
#include <vector>

namespace meetc {

// All members enqueue their work on the device's stream and throw device_error.
class hit_pairs {
public:
  // Owners: the item of each element; empty: each element is its own item.
  hit_pairs(device &on, const device_set &a, const device_set &b, std::span<const std::uint32_t> owner_a,
            std::span<const std::uint32_t> owner_b);

  bool owned() const { return !owner_a_.empty() || !owner_b_.empty(); }
  // Throws std::invalid_argument where a map has not one item for each element.
  void upload_owners();
  // Of B's elements, on the device, after upload_owners(); null: there are none.
  const std::uint32_t *owners_there_b() const { return there_b_.data(); }

  // Whether all hits of a query can be ordered where they are, of which there is room for this many. Elements must be their own
  // items, and it takes memory.
  bool can_order(std::size_t hits);
  // Enqueues that, after can_order(). `counted` has room_to_order, of which few hits need none, and `unordered` is one number;
  // all are 0 at first. `expected` is a guess. Where few were expected and there are more, or where too many are of items that
  // are near each other, `unordered` is not 0 at the end; the hits are then to be added.
  void order(const cuda::pair_list &hits, unsigned long long *counted, unsigned long long *unordered,
             hit_amount expected);
  static constexpr std::size_t room_to_order = cuda::counted_to_distribute / 2; // numbers
  // n hits were ordered.
  void take_ordered(std::size_t n) { keys_ = n, ordered_ = true; }
  // They were not, because too many are of items that are near each other.
  void take_crowded() { crowded_ = true; }

  // Adds n hits, pairs of slots.
  void add(const index_pair *hits, std::size_t n);

  // Sorts and drops repeats, without a list if only their number is asked for. Waits for the device; `sorted` is called when
  // all work but downloading has been enqueued. Fills the rest of the answer; `left_there` is that of query().
  void finish(answer_kind want, result &r, const std::function<void()> &sorted, pairs_there *left_there);

private:
  void spill();
  unsigned long long counted(); // at the first of the query's counters
  bool order_keys_there(int bits);
  bool sort_on_device();

  device &on_;
  device_buffers &buffers_;
  const device_set &a_, &b_;
  std::span<const std::uint32_t> owner_a_, owner_b_;
  device_memory<std::uint32_t> there_a_, there_b_; // the owners
  int bits_a_, bits_b_;                            // of the largest item's number
  std::size_t keys_ = 0;
  bool ordered_ = false, crowded_ = false;
  std::vector<index_pair> spilled_;
};

} // namespace meetc

#endif
