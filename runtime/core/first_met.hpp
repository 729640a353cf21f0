// core/first_met.hpp: of each element of a set, the element of another one that it meets first on its way from its first
// point to its second, found without a list of pairs.
#ifndef MEETC_CORE_FIRST_MET_HPP
#define MEETC_CORE_FIRST_MET_HPP

#include "core/decide.hpp"
#include "core/element_set.hpp"

#include <span>
#include <vector>

namespace meetc {

// Takes hits by their slots, from all workers at once. The order is total and the least number counts where several elements
// (or items) are met at one point, so that the result does not depend on the order in which hits come.
class first_of_each final : public hit_taker {
public:
  // `order` is predicate_info::first_met. owner_b: the items of b's elements, or empty.
  first_of_each(const element_set &a, const element_set &b, std::span<const std::uint32_t> owner_b,
                decltype(predicate_info::first_met) order);

  void take(int worker, const index_pair *hits, std::size_t n) override;

  // For each of so many elements that `a` was filled from: the number of an element (or item) of b, or no_element.
  std::vector<std::uint32_t> by_element(std::size_t elements) const;

private:
  std::uint32_t number_of(std::uint32_t slot) const;

  const element_set &a_, &b_;
  std::span<const std::uint32_t> owner_b_;
  decltype(predicate_info::first_met) order_;
  std::vector<std::uint32_t> first_; // slots of b by slots of a
};

} // namespace meetc

#endif
