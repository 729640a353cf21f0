// core/traversal/walk_cost.hpp: the expected cost of a walk, by which its side and its way are chosen.
//
// The model: the boxes of a level have its mean widths and lie anywhere in the box around both sets, with equal
// probability. Two boxes then touch with the probability that the box of their summed widths has there, and a segment
// and a box with that of their Minkowski sum. Each box that is touched costs one test of sixteen lanes,
// and one by points costs four.
#ifndef MEETC_CORE_TRAVERSAL_WALK_COST_HPP
#define MEETC_CORE_TRAVERSAL_WALK_COST_HPP

#include "meet/core/traversal/candidate_operand.hpp"

namespace meetc {

class walk_cost {
public:
  // The costs of walks of `walker` down the hierarchy of `tree`. Both sets have elements.
  walk_cost(const candidate_operand &walker, const candidate_operand &tree);

  // Whether the elements of this block are expected to cost less one by one, by their points, than together.
  bool one_by_one(std::size_t block) const;
  // The expected cost of all blocks, in tests of boxes.
  double of_all() const;

private:
  struct shares { // of the region, along each axis
    double of[3];
  };
  shares share(const double widths[3]) const;
  double together(const shares &block, const shares &element) const;
  double one(const shares &element) const;

  candidate_operand walker_;
  double region_[3];
  int depth_;       // of the hierarchy that is walked
  double boxes_[9]; // by level
  shares nodes_[9] = {};
};

} // namespace meetc

#endif
