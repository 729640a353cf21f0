#include "meet/core/device/answers/element_pairs.hpp"

#include "meet/core/device/memory/buffers.hpp"

#include <utility>

namespace meetc::on_device {

void element_pairs::start(const queried_sets &sets) {
  sets_.emplace(sets);
  keys_.emplace(sets, std::span<const std::uint32_t>(), std::span<const std::uint32_t>());
}

void element_pairs::take_early(const cuda::pair_list &hits) {
  constexpr std::size_t most = 0x7fffffff;
  const auto &[on, a, b] = *sets_;
  device_buffers &buffers = on.buffers();
  early_ = hits.capacity <= most && buffers.keys.grow(hits.capacity, 0, on.stream()) &&
           buffers.more_keys.grow(hits.capacity, 0, on.stream());
  if (!early_)
    return;
  check(order_hits({.hits = hits.pairs,
                    .count = hits.count,
                    .capacity = hits.capacity,
                    .order_a = a.order(),
                    .order_b = b.order(),
                    .items_a = a.numbers(),
                    .items_b = b.numbers(),
                    .counted = buffers.to_order.data(),
                    .by_cell = buffers.keys.data(),
                    .sorted = reinterpret_cast<index_pair *>(buffers.more_keys.data()),
                    .unordered = buffers.count_of(counter::unordered)},
                   on.stream()),
        "sorting pairs");
}

void element_pairs::take(const part_hits &hits) {
  const device_buffers &buffers = sets_->on.buffers();
  if (hits.whole && early_ && buffers.seen_of(counter::unordered) == 0) {
    ordered_ = hits.n;
    return;
  }
  keys_->add(hits.pairs, hits.n);
}

void element_pairs::finish() {
  if (!ordered_)
    keys_->sort();
}

void element_pairs::download(device_result &r) {
  device_buffers &buffers = sets_->on.buffers();
  device_memory<std::uint64_t> &sorted = ordered_ ? buffers.more_keys : buffers.keys;
  if (left_there_ && (ordered_ || keys_->there()))
    left_there_->exchange(sorted, ordered_.value_or(keys_->size()));
  else
    r.pairs = ordered_ ? download_pairs(sets_->on, reinterpret_cast<const index_pair *>(sorted.data()), *ordered_)
                       : keys_->take_list();
}

} // namespace meetc::on_device
