// core/pair_sort.hpp: sorts pairs by a, then b, on one thread.
//
// Method: many pairs are sorted by their digits. Where there are few and their a lie close together, the pairs are dealt
// out by a, and those of each a are inserted in order; that takes a third of the time of a comparison sort.
#ifndef MEETC_CORE_PAIR_SORT_HPP
#define MEETC_CORE_PAIR_SORT_HPP

#include "meetc/support.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace meetc {

struct sort_scratch { // grows as needed
  std::vector<index_pair> pairs;
  std::vector<std::uint32_t> ends;
};
// Sorts by a, then b.
void sort_pairs(index_pair *pairs, std::size_t n, sort_scratch &scratch);

// Drops the repeats in a sorted list.
void drop_repeats(std::vector<index_pair> &sorted);

// The pairs (b, a), sorted.
std::vector<index_pair> transposed(std::vector<index_pair> pairs);

// Whether deal_out() pays for n pairs whose a differ in their low `bits` bits alone: not where most of those a have none.
inline bool may_be_dealt_out(std::size_t n, int bits) {
  constexpr int most_bits = 16; // the counts stay in a cache
  return bits <= most_bits && std::size_t{1} << bits <= 4 * n && n <= 0xffffffff;
}

// Sorts the pairs of each a by b, given where those of each end. No a has more than `most`.
void sort_each(index_pair *pairs, std::span<const std::uint32_t> ends, std::uint32_t most);

// Sorts such pairs from elsewhere to `to`. each(f) calls f(pairs, count) for all pieces of them, and is called twice.
template <class Each> void deal_out(const Each &each, index_pair *to, int bits, std::vector<std::uint32_t> &ends) {
  const std::uint32_t low = (std::uint32_t{1} << bits) - 1;
  ends.assign(std::size_t{low} + 1, 0);
  each([&ends, low](const index_pair *pairs, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      ++ends[pairs[i].a & low];
  });
  std::uint32_t sum = 0, most = 0;
  for (std::uint32_t &end : ends) {
    const std::uint32_t count = end;
    end = sum;
    sum += count;
    most = std::max(most, count);
  }
  each([&ends, low, to](const index_pair *pairs, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      to[ends[pairs[i].a & low]++] = pairs[i];
  });
  sort_each(to, ends, most);
}

} // namespace meetc

#endif
