// core/candidates.hpp: the sources of candidate pairs. Code that decides pairs does not know which source they come
// from.
//
// A source divides its work into units that may run in any order on any thread. Together they yield each candidate
// exactly once. A candidate is a pair whose boxes may touch, and of which, where that is asked for, an element with two
// hull points may touch the other's box. Both sources yield the same candidates, but for those that a filter by signs rules
// out. Pairs come in runs of one element, of either set, and a run is never split between two batches.
#ifndef MEETC_CORE_CANDIDATES_HPP
#define MEETC_CORE_CANDIDATES_HPP

#include "core/affine_pairs.hpp"
#include "core/candidate_operand.hpp"
#include "core/pair_filter.hpp"
#include "core/walk_cost.hpp"

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

class candidate_source {
public:
  virtual ~candidate_source() = default;
  virtual std::size_t units() const = 0;
  virtual bool yield(std::size_t unit, pair_sink &sink) const = 0; // false: the sink asked to stop
};

// Tests every pair, or those that filters leave: that by balls, and where it leaves much, the one by signs. The sets and the
// filters must outlive it.
class all_pairs final : public candidate_source {
public:
  all_pairs(const element_set &a, const element_set &b, ruled_out_by what, const pair_filter *filter = nullptr,
            const affine_pairs *signs = nullptr)
      : a_(a, what), b_(b, what), filter_(filter), signs_(signs) {}
  std::size_t units() const override;
  bool yield(std::size_t unit, pair_sink &sink) const override;

private:
  candidate_operand a_, b_;
  const pair_filter *filter_; // null: there is none
  const affine_pairs *signs_; // likewise
};

// Walks the hierarchy of one set with each block of the other, or with each of its elements: which set walks, and how,
// is what is expected to take fewer tests. The sets must outlive it. With `half` they are one set, and of two pairs that
// differ only in their order it yields the one with a <= b.
class tree_pairs final : public candidate_source {
public:
  tree_pairs(const element_set &a, const element_set &b, ruled_out_by what, bool half = false);
  std::size_t units() const override;
  bool yield(std::size_t unit, pair_sink &sink) const override;

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
