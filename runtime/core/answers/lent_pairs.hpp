// core/answers/lent_pairs.hpp: the pairs in an array that a caller lends, in no order.
#ifndef MEETC_CORE_ANSWERS_LENT_PAIRS_HPP
#define MEETC_CORE_ANSWERS_LENT_PAIRS_HPP

#include "meet/core/answers/query_answer.hpp"

#include <atomic>

namespace meetc {

// Where there are more than `capacity` pairs, only some are written. It allocates nothing.
class lent_pairs final : public query_answer {
public:
  lent_pairs(index_pair *to, std::size_t capacity) : to_(to), capacity_(capacity) {}
  void start(const queried_sets &) override { next_ = 0; }
  void take(int, const index_pair *hits, std::size_t n) override {
    const std::uint64_t at = next_.fetch_add(n, std::memory_order_relaxed);
    if (at < capacity_)
      std::copy_n(hits, std::min<std::uint64_t>(n, capacity_ - at), to_ + at);
  }
  void finish(result &) override {}

private:
  index_pair *to_;
  std::size_t capacity_;
  std::atomic<std::uint64_t> next_{0};
};

} // namespace meetc

#endif
