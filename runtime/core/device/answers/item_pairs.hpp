// core/device/answers/item_pairs.hpp: answers about items that own elements, from the list of the pairs of items.
#ifndef MEETC_CORE_DEVICE_ANSWERS_ITEM_PAIRS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_ITEM_PAIRS_HPP

#include "meet/core/device/answers/hit_keys.hpp"

#include <optional>

namespace meetc::on_device {

class item_pairs final : public query_answer {
public:
  // Owners: the item of each element; empty: each element is its own item. Any kind of answer that a list can become.
  item_pairs(answer_kind want, std::span<const std::uint32_t> owner_a, std::span<const std::uint32_t> owner_b)
      : want_(want), owner_a_(owner_a), owner_b_(owner_b) {}

  void start(const queried_sets &sets) override {
    keys_.emplace(sets, owner_a_, owner_b_);
    items_a_ = items(owner_a_, sets.a.numbers()), items_b_ = items(owner_b_, sets.b.numbers());
  }
  void take(const part_hits &hits) override { keys_->add(hits.pairs, hits.n); }
  void finish() override { keys_->sort(); }
  void download(device_result &r) override {
    if (want_ == answer_kind::count) {
      r.count = keys_->size();
      return;
    }
    r.pairs = keys_->take_list();
    answer_from_list(want_, items_a_, items_b_, r);
  }

private:
  answer_kind want_;
  std::span<const std::uint32_t> owner_a_, owner_b_;
  std::size_t items_a_ = 0, items_b_ = 0;
  std::optional<hit_keys> keys_;
};

} // namespace meetc::on_device

#endif
