// core/answers/element_pairs.hpp: the sorted list of all pairs.
#ifndef MEETC_CORE_ANSWERS_ELEMENT_PAIRS_HPP
#define MEETC_CORE_ANSWERS_ELEMENT_PAIRS_HPP

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/answers/query_answer.hpp"

namespace meetc {

class element_pairs final : public query_answer {
public:
  void start(const queried_sets &sets) override { lists_.resize(static_cast<std::size_t>(sets.workers)); }
  void take(int worker, const index_pair *hits, std::size_t n) override {
    lists_[static_cast<std::size_t>(worker)].add(hits, n);
  }
  void finish(result &r) override {
    const int threads = static_cast<int>(lists_.size());
    r.pairs = sorted(std::move(lists_), threads);
  }

private:
  std::vector<pair_list> lists_; // by worker
};

} // namespace meetc

#endif
