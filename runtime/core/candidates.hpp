// core/candidates.hpp: the sources of candidate pairs. Code that decides pairs does not know which source they come
// from.
//
// A source divides its work into units that may run in any order on any thread. Together they yield each pair whose
// boxes may touch exactly once. Pairs come in runs of one `a`, and a run is never split between two batches.
#ifndef MEETC_CORE_CANDIDATES_HPP
#define MEETC_CORE_CANDIDATES_HPP

#include "core/element_set.hpp"

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

// Tests every pair of boxes. The sets must outlive it.
class all_pairs final : public candidate_source {
public:
  all_pairs(const element_set &a, const element_set &b) : a_(a), b_(b) {}
  std::size_t units() const override;
  bool yield(std::size_t unit, pair_sink &sink) const override;

private:
  const element_set &a_, &b_;
};

// Walks the hierarchy of b with each block of a. The sets must outlive it.
class tree_pairs final : public candidate_source {
public:
  tree_pairs(const element_set &a, const element_set &b);
  std::size_t units() const override;
  bool yield(std::size_t unit, pair_sink &sink) const override;

private:
  const element_set &a_, &b_;
  int start_ = 0;          // the level of b at which a walk starts
  std::size_t starts_ = 0; // blocks of that level
};

} // namespace meetc

#endif
