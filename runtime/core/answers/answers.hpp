// core/answers/answers.hpp: what a query can answer, and how a list of pairs becomes answers about elements.
#ifndef MEETC_CORE_ANSWERS_ANSWERS_HPP
#define MEETC_CORE_ANSWERS_ANSWERS_HPP

#include "meetc/support.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meetc {

// Every kind but `any` and `none` also counts the pairs. Unless there are owners, only `pairs` takes memory that grows with the
// pairs.
enum class answer_kind : std::uint8_t {
  pairs,  // the list of all pairs, sorted by a, then b
  count,  // how many pairs there are
  counts, // for each element of both sets, the number of pairs that it is in
  flags,  // for each element of both sets, 1 if it is in a pair and 0 if not
  any,    // whether there is a pair; the count is 0 or 1, and the search stops at the first
  none,   // nothing but what each element of a meets first, which must be asked for; the count is 0
};

// Counts of the rungs of `certified`; the other rungs do not change them.
struct rung_report {
  std::uint64_t unsure[bounded_rungs] = {0, 0, 0}; // pairs of elements that fp32, fp64 and fp64x2 left unsure
  bool left_box_a = false, left_box_b = false;     // some number of this set lies outside the stated box
};

// In a list of elements: there is none.
inline constexpr std::uint32_t no_element = ~std::uint32_t{0};

// Indexed by the elements (or items) of the two sets. Both are empty for other kinds of answers.
template <class T> struct per_element { std::vector<T> a, b; };

// Every member but the count is empty unless it was asked for.
struct result {
  std::vector<index_pair> pairs; // sorted by a, then b; no pair twice
  std::uint64_t count = 0; // pairs, or pairs of items where there are owners; 0 or 1 for answer_kind::any, 0 for none
  per_element<std::uint8_t> flags;
  per_element<std::uint64_t> counts;
  // For each element of a, the element (or item) of b that it meets first on its way from its first point to its second, and
  // of those that it meets at one point the least; no_element where it meets none.
  std::vector<std::uint32_t> first_met;
  std::uint64_t candidates = 0; // pairs of elements that were decided
  rung_report rungs;            // the same for any number of threads, except for answer_kind::any
  double seconds = 0;           // wall-clock time of the call
};

// For pairs (a, b) with a < size_a and b < size_b, each once in the list.
per_element<std::uint64_t> counts_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b);
per_element<std::uint8_t> flags_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b);

// Turns the list in r.pairs, which is sorted and holds no pair twice, into the answer that is wanted. It serves engines
// that find lists, such as the one on a device.
void answer_from_list(answer_kind want, std::size_t size_a, std::size_t size_b, result &r);

// Turns numbers of elements into those of their items; no_element stays. Without owners nothing changes.
void name_items(std::span<const std::uint32_t> owners, std::vector<std::uint32_t> &elements);

// The number of items: the number of elements where there are no owners, else the largest owner plus one.
std::size_t items(std::span<const std::uint32_t> owners, std::size_t elements);

} // namespace meetc

#endif
