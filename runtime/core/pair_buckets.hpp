// core/pair_buckets.hpp: the pairs that threads find, and one sorted list of them.
//
// Method: each worker deals its pairs into 256 buckets by the high bits of a, while it finds them. A bucket is a chain of
// small blocks, so no pair moves when it grows. Then all threads take buckets: the pairs of a bucket are dealt out by the
// rest of a, from the blocks of every worker to their place in the list, and the few of each a are inserted in order. Where
// its a lie far apart a bucket is sorted by digits. The list depends on the pairs alone.
#ifndef MEETC_CORE_PAIR_BUCKETS_HPP
#define MEETC_CORE_PAIR_BUCKETS_HPP

#include "core/memory.hpp"
#include "meetc/support.hpp"

#include <cstddef>
#include <vector>

namespace meetc {

// The pairs of one worker.
class alignas(64) pair_buckets {
public:
  // All buckets of a list are made with the same most_a, and no pair has a larger a.
  explicit pair_buckets(std::uint32_t most_a);

  void add(const index_pair *pairs, std::size_t n);

private:
  friend class bucket_sort;
  static constexpr std::size_t count = 256;
  struct block {
    static constexpr std::uint32_t most = 255;
    index_pair pairs[most];
    block *before; // in the chain
  };
  struct bucket {
    block *last = nullptr;
    std::uint32_t in_last = block::most;
    std::size_t blocks = 0;
    std::size_t size() const { return blocks * block::most + in_last - block::most; }
  };

  void deal(const index_pair *pairs, std::size_t n);
  void deal_few(); // from here on there are buckets
  void begin_block(bucket &in);
  // Calls each(pairs, n) for the blocks of a bucket.
  template <class Each> void visit(std::size_t k, const Each &each) const {
    const bucket &b = buckets_[k];
    std::size_t n = b.in_last;
    for (const block *at = b.last; at; at = at->before, n = block::most)
      each(at->pairs, n);
  }

  int shift_;
  std::vector<index_pair> few_; // all pairs, as long as they are too few for buckets
  std::vector<bucket> buckets_;
  std::vector<owned_memory> memory_;
  block *free_ = nullptr, *end_ = nullptr; // of the last piece of memory
};

// All pairs of all workers, sorted. The memory of the buckets is freed.
std::vector<index_pair> sort_together(std::vector<pair_buckets> from, int threads);

// All pairs of all lists, sorted. The lists are emptied.
std::vector<index_pair> sort_together(std::vector<std::vector<index_pair>> &lists, int threads);

} // namespace meetc

#endif
