// core/pair_sort.hpp: turns the lists of pairs that threads collect into one sorted list.
//
// Method: pairs are dealt into at most 256 buckets by the high bits of a, then each bucket is sorted by its digits.
// Both steps run on all threads. Beside the result they need one bucket for each thread.
#ifndef MEETC_CORE_PAIR_SORT_HPP
#define MEETC_CORE_PAIR_SORT_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <vector>

namespace meetc {

// Sorts by a, then b. `scratch` grows as needed.
void sort_pairs(index_pair *pairs, std::size_t n, std::vector<index_pair> &scratch);

// Drops the repeats in a sorted list.
void drop_repeats(std::vector<index_pair> &sorted);

// The pairs (b, a), sorted.
std::vector<index_pair> transposed(std::vector<index_pair> pairs);

// All pairs of all lists, sorted. The lists are emptied.
std::vector<index_pair> sort_together(std::vector<std::vector<index_pair>> &lists, int threads);

} // namespace meetc

#endif
