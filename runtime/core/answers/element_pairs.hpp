// core/answers/element_pairs.hpp: the sorted list of all pairs.
#ifndef MEETC_CORE_ANSWERS_ELEMENT_PAIRS_HPP
#define MEETC_CORE_ANSWERS_ELEMENT_PAIRS_HPP

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/answers/query_answer.hpp"

namespace meetc {

class element_pairs final : public query_answer {
public:
  void start(const queried_sets &sets) override {
    on_ = sets.on;
    lists_.resize(static_cast<std::size_t>(on_.threads));
  }
  void take(int worker, const index_pair *hits, std::size_t n) override {
    lists_[static_cast<std::size_t>(worker)].add(hits, n);
  }
  void finish(result &r) override { r.pairs = sorted(std::move(lists_), on_); }

private:
  execution on_ = 1;
  std::vector<pair_list> lists_; // by worker
};

} // namespace meetc

#endif
