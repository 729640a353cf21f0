// core/traversal/probe.hpp: one element against blocks of another set, which writes its candidates.
#ifndef MEETC_CORE_TRAVERSAL_PROBE_HPP
#define MEETC_CORE_TRAVERSAL_PROBE_HPP

#include "meet/core/hierarchy/two_points.hpp"
#include "meet/core/traversal/candidate_operand.hpp"

#include <bit>

namespace meetc {

// The two points of the element in a slot.
inline two_points points_at(const element_set &set, std::size_t slot) {
  return two_points_of(*set.kind, set.rows + slot * static_cast<std::size_t>(set.kind->fields));
}

class probe {
public:
  // The element in `slot` of `one`. With swapped, it is the second of each pair.
  probe(const candidate_operand &one, std::size_t slot, const candidate_operand &other, bool swapped)
      : one_(one), other_(other), slot_(slot), box_(one.set.boxes.levels[0].get(slot)), swapped_(swapped) {
    if (one.by_points)
      points_ = points_at(one.set, slot);
  }

  // The element's points; there are some if it is tested by them.
  const two_points &points() const { return points_; }

  // Writes the pairs with those elements of a block whose boxes it touches, at most sixteen, and returns their end.
  index_pair *pairs_among(std::size_t block, std::uint32_t mask, index_pair *out) const {
    if (one_.by_points && mask != 0)
      mask &= touching(other_.set.boxes.levels[0].blocks[block], points_);
    return pairs_of(block, mask, out);
  }
  // The same without the mask, for an element with points whose box holds most of the others: the points are tested first.
  index_pair *pairs_by_points(std::size_t block, index_pair *out) const {
    const box_block &boxes = other_.set.boxes.levels[0].blocks[block];
    std::uint32_t mask = touching(boxes, points_);
    if (mask != 0)
      mask &= touching(boxes, box_);
    return pairs_of(block, mask, out);
  }

private:
  index_pair *pairs_of(std::size_t block, std::uint32_t mask, index_pair *out) const {
    const auto mine = static_cast<std::uint32_t>(slot_), first = static_cast<std::uint32_t>(block * lanes);
    for (; mask != 0; mask &= mask - 1) {
      const std::uint32_t theirs = first + static_cast<std::uint32_t>(std::countr_zero(mask));
      if (other_.by_points && !touches_points_of(theirs))
        continue;
      *out++ = swapped_ ? index_pair{theirs, mine} : index_pair{mine, theirs};
    }
    return out;
  }

  bool touches_points_of(std::size_t slot) const {
    const box_block &mine = one_.set.boxes.levels[0].blocks[slot_ / lanes];
    return touching(mine, points_at(other_.set, slot)) >> slot_ % lanes & 1;
  }

  const candidate_operand &one_, &other_;
  std::size_t slot_;
  box box_;
  two_points points_;
  bool swapped_;
};

} // namespace meetc

#endif
