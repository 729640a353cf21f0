// core/answers.hpp: what a query can answer, and what a list of pairs says of each element.
#ifndef MEETC_CORE_ANSWERS_HPP
#define MEETC_CORE_ANSWERS_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meetc {

// Every kind but `any` also counts the pairs. Without owners all but `pairs` take memory that does not grow
// with the pairs.
enum class answer_kind : std::uint8_t {
  pairs,  // the list of all pairs, sorted by a, then b
  count,  // how many pairs there are
  counts, // of each element of either set, in how many pairs it is
  flags,  // of each element of either set, 1 where it is in a pair and 0 where it is in none
  any,    // whether there is a pair: the count is 0 or 1, and the search stops at the first
};

// By element (or item) of the two sets; both empty where the kind of answer is another.
template <class T> struct per_element { std::vector<T> a, b; };

// Of pairs (a, b) of a < size_a and b < size_b, each pair once in the list.
per_element<std::uint64_t> counts_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b);
per_element<std::uint8_t> flags_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b);

// How many items there are: the elements where there are no owners, else the largest owner and one more.
std::size_t items(std::span<const std::uint32_t> owners, std::size_t elements);

} // namespace meetc

#endif
