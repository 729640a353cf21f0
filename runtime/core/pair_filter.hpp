// core/pair_filter.hpp: the separable filter of two sets, by which a query that looks at all pairs leaves out most tests
// of boxes.
#ifndef MEETC_CORE_PAIR_FILTER_HPP
#define MEETC_CORE_PAIR_FILTER_HPP

#include "core/element_set.hpp"
#include "core/memory.hpp"

namespace meetc {

class pair_filter {
public:
  // Whether the predicate's kinds have filters, and the sets are so large that making the numbers costs less than it
  // saves.
  static bool pays(const predicate_info &predicate, const element_set &a, const element_set &b);

  // The kinds have filters. The sets need not outlive it. Throws std::bad_alloc.
  pair_filter(const predicate_info &predicate, const element_set &a, const element_set &b, int threads);

  // Writes which of the blocks of b from `first` on, `count` of them, may hold an element whose box touches that of a's
  // element in `slot`. Their indices count from `first`, which is a multiple of filter_tile. Returns the end.
  near_tile *near(std::size_t slot, std::size_t first, std::size_t count, near_tile *out) const {
    return near_(floats(singles_) + slot * floats_, floats(groups_) + first * floats_,
                 floats(tiles_) + first * filter_tile * floats_, count, out);
  }

private:
  static const float *floats(const owned_memory &m) { return static_cast<const float *>(m.get()); }

  std::size_t floats_;
  near_tile *(*near_)(const float *, const float *, const float *, std::size_t, near_tile *);
  owned_memory singles_, tiles_, groups_; // of a, and of b, where tiles start on cache lines
};

} // namespace meetc

#endif
