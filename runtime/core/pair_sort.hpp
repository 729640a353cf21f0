// core/pair_sort.hpp: turns the lists of pairs that threads collect into one sorted list.
//
// Method: pairs are dealt into at most 256 buckets by the high bits of a. A large bucket is sorted by its digits. In a small
// one whose a lie close together the pairs are dealt out by the rest of a, and those of each a are inserted in order; that
// takes a third of the time of a comparison sort. Both steps run on all threads. Beside the result they need one bucket for
// each thread.
#ifndef MEETC_CORE_PAIR_SORT_HPP
#define MEETC_CORE_PAIR_SORT_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <vector>

namespace meetc {

struct sort_scratch { // grows as needed
  std::vector<index_pair> pairs;
  std::vector<std::uint32_t> ends;
};
// Sorts by a, then b.
void sort_pairs(index_pair *pairs, std::size_t n, sort_scratch &scratch);

// Adds pairs at the end of a list, which may become long.
void add_pairs(std::vector<index_pair> &to, const index_pair *pairs, std::size_t n);

// Drops the repeats in a sorted list.
void drop_repeats(std::vector<index_pair> &sorted);

// The pairs (b, a), sorted.
std::vector<index_pair> transposed(std::vector<index_pair> pairs);

// All pairs of all lists, sorted. The lists are emptied.
std::vector<index_pair> sort_together(std::vector<std::vector<index_pair>> &lists, int threads);

} // namespace meetc

#endif
