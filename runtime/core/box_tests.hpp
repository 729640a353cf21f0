// core/box_tests.hpp: tests of one box against blocks of sixteen, for each instruction set.
//
// Problem: two thirds of a query's time go into these tests, and this library is compiled for the baseline.
// Method: the functions have their instruction set as an attribute, and are chosen when the program runs. Nothing else is
// compiled for that set, so no inline function of the library is. They only compare, as touching() in core/box.hpp does,
// so every set finds the same pairs in the same order.
#ifndef MEETC_CORE_BOX_TESTS_HPP
#define MEETC_CORE_BOX_TESTS_HPP

#include "core/box.hpp"
#include "meetc/support.hpp"

namespace meetc {

// The pairs of one element with the elements of some blocks.
struct block_query {
  const box_block *blocks;      // of the other set, in the order of its slots
  const std::uint32_t *numbers; // of the blocks that are asked
  std::size_t count;
  box around; // the element's box
  std::uint32_t slot;
  bool swapped; // the element is the second of each pair
};

// A block of elements against sixteen blocks of the other set.
struct leaf_query {
  const box_block *walker, *leaves; // the elements, and all blocks of the other set
  const box_block *around_leaves;   // the boxes around the sixteen
  std::uint32_t first, from;        // the number of the first of them, and the first number that is wanted
  box around;                       // the box around the elements
};

struct box_tests {
  instruction_set compiled_for;
  // As touching().
  std::uint32_t (*touching)(const box_block &block, const box &q);
  // Writes the pairs whose boxes may touch, block by block, and returns their end. There is room for count * lanes.
  index_pair *(*pairs)(const block_query &q, index_pair *out);
  // Writes the numbers of the blocks that have an element which touches the box around the walkers, and with each the
  // walkers that touch the box around it, if there are any. Returns how many blocks there are, at most sixteen.
  std::size_t (*leaves)(const leaf_query &q, std::uint32_t *numbers, std::uint32_t *elements);
};

// Null where the processor does not run the set, or the compiler knows no such attribute.
const box_tests *box_tests_for(instruction_set set);

// Those of the best set.
const box_tests &best_box_tests();

} // namespace meetc

#endif
