// core/answers/item_pairs.hpp: answers about items that own elements, from the list of the pairs of items.
//
// Each worker's list is compacted whenever it has doubled, so that memory grows with the number of distinct pairs.
#ifndef MEETC_CORE_ANSWERS_ITEM_PAIRS_HPP
#define MEETC_CORE_ANSWERS_ITEM_PAIRS_HPP

#include "meet/core/answers/query_answer.hpp"

namespace meetc {

class item_pairs final : public query_answer {
public:
  // Owners: the item of each element; empty: each element is its own item. Any kind of answer that a list can become.
  item_pairs(answer_kind want, std::span<const std::uint32_t> owner_a, std::span<const std::uint32_t> owner_b);

  void start(const queried_sets &sets) override;
  void take(int worker, const index_pair *hits, std::size_t n) override;
  void finish(result &r) override;

private:
  static constexpr std::size_t first_compaction = std::size_t{1} << 18;
  struct alignas(64) list {
    std::vector<index_pair> pairs;
    std::size_t compact_at = first_compaction;
  };
  answer_kind want_;
  execution on_ = 1;
  std::span<const std::uint32_t> owner_a_, owner_b_;
  std::size_t items_a_ = 0, items_b_ = 0;
  std::vector<list> lists_; // by worker
};

} // namespace meetc

#endif
