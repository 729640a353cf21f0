// core/answers/any_pair.hpp: whether there is a pair.
#ifndef MEETC_CORE_ANSWERS_ANY_PAIR_HPP
#define MEETC_CORE_ANSWERS_ANY_PAIR_HPP

#include "meet/core/answers/query_answer.hpp"

#include <atomic>

namespace meetc {

// The count becomes 0 or 1.
class any_pair final : public query_answer {
public:
  void start(const queried_sets &) override { found_ = false; }
  void take(int, const index_pair *, std::size_t) override { found_.store(true, std::memory_order_relaxed); }
  void finish(result &r) override { r.count = done() ? 1 : 0; }
  bool needs_pairs() const override { return false; }
  bool stops_early() const override { return true; }
  bool done() const override { return found_.load(std::memory_order_relaxed); }

private:
  std::atomic<bool> found_{false};
};

} // namespace meetc

#endif
