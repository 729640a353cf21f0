// core/traversal/candidates.hpp: the search for candidate pairs, by the hierarchies of two sets.
//
// The search divides its work into units that may run in any order on any thread. Together they yield each candidate
// exactly once. A candidate is a pair whose boxes may touch, and of which, where that is asked for, an element with two
// hull points may touch the other's box. Pairs come in runs of one element, of either set, and a run is never split between
// two batches.
#ifndef MEETC_CORE_TRAVERSAL_CANDIDATES_HPP
#define MEETC_CORE_TRAVERSAL_CANDIDATES_HPP

#include "meet/core/traversal/candidate_operand.hpp"
#include "meet/core/traversal/walk_cost.hpp"

#include <optional>

namespace meetc {

// Takes pairs of slots. Each thread has one.
class pair_sink {
public:
  static constexpr std::size_t longest_run = 4096;

  virtual ~pair_sink() = default;

  // Has room for at least longest_run pairs.
  index_pair *room() { return pairs_ + size_; }
  // Says that n pairs have been written there. Returns false to stop.
  bool advance(std::size_t n) {
    size_ += n;
    return size_ < full_ || flush();
  }

protected:
  virtual bool flush() = 0; // empties the sink; false means stop

  index_pair *pairs_ = nullptr;
  std::size_t size_ = 0, full_ = 0;
};

// Walks the hierarchy of one set with each block of the other, or with each of its elements: which set walks, and how,
// is what is expected to take fewer tests. The sets must outlive it. With `half` they are one set, and of two pairs that
// differ only in their order it yields the one with a <= b.
class tree_pairs {
public:
  tree_pairs(const element_set &a, const element_set &b, ruled_out_by what, bool half = false);
  std::size_t units() const;
  bool yield(std::size_t unit, pair_sink &sink) const; // false: the sink asked to stop

private:
  candidate_operand a_, b_;
  std::optional<walk_cost> cost_; // of the walks of this set; empty where a set is
  bool b_walks_ = false;          // the blocks of b walk the hierarchy of a
  bool half_;
  int start_ = 0;          // the level at which a walk starts
  std::size_t starts_ = 0; // blocks of that level
};

} // namespace meetc

#endif
