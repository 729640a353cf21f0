#include "meet/core/answers/item_pairs.hpp"

#include "meet/core/answers/pair_list.hpp"

namespace meetc {

item_pairs::item_pairs(answer_kind want, std::span<const std::uint32_t> owner_a, std::span<const std::uint32_t> owner_b)
    : want_(want), owner_a_(owner_a), owner_b_(owner_b) {}

void item_pairs::start(const queried_sets &sets) {
  items_a_ = items(owner_a_, sets.elements_a), items_b_ = items(owner_b_, sets.elements_b);
  on_ = sets.on;
  lists_.resize(static_cast<std::size_t>(on_.threads));
}

void item_pairs::take(int worker, const index_pair *hits, std::size_t n) {
  list &mine = lists_[static_cast<std::size_t>(worker)];
  for (std::size_t i = 0; i < n; ++i)
    mine.pairs.push_back(
        {owner_a_.empty() ? hits[i].a : owner_a_[hits[i].a], owner_b_.empty() ? hits[i].b : owner_b_[hits[i].b]});
  if (mine.pairs.size() < mine.compact_at)
    return;
  sort_pairs(mine.pairs, on_);
  drop_repeats(mine.pairs);
  mine.compact_at = std::max(first_compaction, 2 * mine.pairs.size());
}

void item_pairs::finish(result &r) {
  std::vector<pair_span> lists;
  for (const list &l : lists_)
    lists.emplace_back(l.pairs);
  r.pairs = sorted(lists, on_);
  drop_repeats(r.pairs);
  answer_from_list(want_, items_a_, items_b_, r);
}

} // namespace meetc
