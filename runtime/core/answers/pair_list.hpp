// core/answers/pair_list.hpp: the pairs that threads find, and one sorted list of them.
#ifndef MEETC_CORE_ANSWERS_PAIR_LIST_HPP
#define MEETC_CORE_ANSWERS_PAIR_LIST_HPP

#include "meet/core/threads/threads.hpp"
#include "meet/core/views/memory.hpp"
#include "meetc/support.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace meetc {

// The pairs of one worker, in pieces, so that no pair moves when there are more.
class alignas(64) pair_list {
public:
  void add(const index_pair *pairs, std::size_t n);

private:
  friend std::vector<index_pair> sorted(std::vector<pair_list> lists, const execution &on);
  struct piece {
    owned_memory memory;
    std::size_t size, room; // pairs
    index_pair *pairs() const { return static_cast<index_pair *>(memory.get()); }
  };
  std::vector<piece> pieces_;
};

using pair_span = std::span<const index_pair>;

// All pairs of all lists, by a, then b.
std::vector<index_pair> sorted(std::vector<pair_list> lists, const execution &on);
std::vector<index_pair> sorted(std::span<const pair_span> lists, const execution &on);

// Sorts by a, then b, on one thread.
void sort_pairs(std::vector<index_pair> &pairs, const execution &on = 1);

// Drops the repeats in a sorted list.
void drop_repeats(std::vector<index_pair> &sorted);

// The pairs (b, a), sorted, on one thread.
std::vector<index_pair> transposed(std::vector<index_pair> pairs);

} // namespace meetc

#endif
