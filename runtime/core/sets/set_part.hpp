// core/sets/set_part.hpp: a part of a filled set, as a set of its own: some of its elements, in its order.
//
// Nothing is computed anew but the boxes around boxes, so a part costs a pass over the numbers of elements and a copy of the
// rows and boxes that it holds.
#ifndef MEETC_CORE_SETS_SET_PART_HPP
#define MEETC_CORE_SETS_SET_PART_HPP

#include "meet/core/sets/normalised.hpp"

#include <span>

namespace meetc {

class set_part {
public:
  // The elements whose items lie in [first, end). owners: the item of each element; empty: each is its own. Throws
  // std::bad_alloc or `cancelled`.
  set_part(const element_set &whole, std::span<const std::uint32_t> owners, std::uint64_t first, std::uint64_t end,
           const execution &on);

  const element_set &set() const { return set_; }
  // Its own values, as prepared::stored() has those of a whole set.
  stored_operand stored(const stored_values &values, const kind_info &of) const {
    return {stored_.of(values, of), values};
  }

private:
  owned_memory bytes_;
  element_set set_;
  stored_table stored_;
};

} // namespace meetc

#endif
