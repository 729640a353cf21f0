// core/answers/first_met.hpp: the element of b that each element of a meets first on its way from its first point to its
// second, found without a list of pairs.
#ifndef MEETC_CORE_ANSWERS_FIRST_MET_HPP
#define MEETC_CORE_ANSWERS_FIRST_MET_HPP

#include "meet/core/answers/query_answer.hpp"

namespace meetc {

// The order is total, and the least number counts where several elements (or items) are met at one point, so that the result
// does not depend on the order in which hits come.
class first_met final : public query_answer {
public:
  // `order` is predicate_info::first_met. owner_b: the items of b's elements, or empty.
  first_met(decltype(predicate_info::first_met) order, std::span<const std::uint32_t> owner_b);

  void start(const queried_sets &sets) override;
  void take(int worker, const index_pair *hits, std::size_t n) override;
  void finish(result &r) override;
  bool by_slots() const override { return true; }

private:
  std::uint32_t number_of(std::uint32_t slot) const;

  decltype(predicate_info::first_met) order_;
  std::span<const std::uint32_t> owner_b_;
  const element_set *a_ = nullptr, *b_ = nullptr;
  std::size_t elements_ = 0;         // of a
  std::vector<std::uint32_t> first_; // slots of b by slots of a
};

} // namespace meetc

#endif
