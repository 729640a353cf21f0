// core/hierarchy/box_tests.hpp: tests of one box against blocks of sixteen, for each instruction set.
//
// Problem: two thirds of a query's time go into these tests, and this library is compiled for the baseline. Method: their
// source is compiled once more for each instruction set, as the kernels are (meetc/environment/instruction_set.hpp), and the
// choice falls when the program runs. They only compare, as touching() in core/hierarchy/box.hpp does, so every set
// finds the same pairs in the same order. The tests of a walk's leaves store their results without a branch: whether two boxes
// touch is as good as random there, and a branch that is predicted wrongly costs more than a test.
#ifndef MEETC_CORE_HIERARCHY_BOX_TESTS_HPP
#define MEETC_CORE_HIERARCHY_BOX_TESTS_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meetc/support.hpp"

namespace meetc {

// A block of elements against at most sixteen blocks of the other set.
struct meeting_query {
  const box_block *walker, *others,
      *around_others;           // the elements, all blocks of the other set, and the boxes around those
  const std::uint32_t *numbers; // of the blocks that are asked
  std::size_t count;
  box around; // the box around the elements
};

// One of those elements with a block of the other set of which it touches some elements.
struct meeting {
  std::uint32_t block_and_lane; // of that block, and of the element: block * lanes + lane
  std::uint32_t mask;           // the elements that are touched

  std::uint32_t block() const { return block_and_lane / lanes; }
  std::uint32_t lane() const { return block_and_lane % lanes; }
};
inline constexpr std::size_t most_meetings = std::size_t{lanes} * lanes;

struct box_tests {
  instruction_set compiled_for;
  // Writes the numbers of the boxes in some blocks that may touch q, block by block, and returns how many there are. There
  // is room for count * lanes.
  std::size_t (*touched)(const box_block *blocks, const std::uint32_t *numbers, std::size_t count, const box &q,
                         std::uint32_t *out);
  // Writes the meetings, element by element, and returns how many there are. There is room for most_meetings.
  std::size_t (*meetings)(const meeting_query &q, meeting *out);
  // Writes the pairs of n meetings, of which lane 0 is element `first`, and returns their end. There is room for n * lanes.
  // With swapped, the element is the second of each pair.
  index_pair *(*pairs_of)(const meeting *meetings, std::size_t n, std::uint32_t first, bool swapped, index_pair *out);
};

// Null where the processor does not run the set, or the library was not compiled for it.
const box_tests *box_tests_for(instruction_set set);

// Those of the best set.
const box_tests &best_box_tests();

} // namespace meetc

#endif
