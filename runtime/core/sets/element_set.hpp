// core/sets/element_set.hpp: a prepared set: rows in spatial order, and the hierarchy of their boxes.
//
// A set may be filled for queries against one other set alone, `counterpart`. It then holds only the elements that can be
// candidates there, so that an element that no query visits costs a test of its box and is not sorted. Each box is tested
// against the box around `counterpart`, and, where `counterpart` has at most a sixteenth as many elements, against the highest
// level of several boxes: a test of sixteen lanes costs about a fifth of what ordering an element does, and a few small
// elements rule out most of a large set.
//
// A slot is a position in that order; `order` maps it to the caller's element. Rows lie in the order of slots, so that
// the rows of one block are read together.
#ifndef MEETC_CORE_SETS_ELEMENT_SET_HPP
#define MEETC_CORE_SETS_ELEMENT_SET_HPP

#include "meet/core/hierarchy/hierarchy.hpp"
#include "meet/core/hierarchy/spatial_order.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/core/views/status.hpp"
#include "meet/core/views/view.hpp"

namespace meetc {

struct element_set {
  const kind_info *kind = nullptr;
  std::size_t elements = 0; // that it holds
  float *rows = nullptr;
  std::uint32_t *order = nullptr;
  box around;                   // all elements that it was filled from; lo > hi if there was none
  float reach = 0, longest = 0; // the magnitudes of all rows that it was filled from
  double grid = 0;              // that of its pose: all numbers are multiples; 0: they are as they were given
  hierarchy boxes;
};

// Memory that is needed to build a set and not kept.
struct set_scratch {
  float *rows = nullptr;
  centre *centres = nullptr;
  std::uint8_t *kept = nullptr; // 1 for an element that the set holds
  std::uint64_t *keys = nullptr, *more_keys = nullptr;
};

// The largest |coordinate| and |length| of some rows; infinite if a field is neither, or a number is not finite.
struct magnitudes {
  float reach = 0, longest = 0;

  void add(const magnitudes &m) { reach = std::max(reach, m.reach), longest = std::max(longest, m.longest); }
};
magnitudes magnitudes_of(const kind_info &kind, const float *rows, std::size_t count);

// The boxes of rows, finite, sixteen in a block; the last lanes of the last block become empty.
void box_rows(const kind_info &kind, const float *rows, std::size_t count, box_block *out);

element_set take_set(bump_allocator &from, const kind_info &kind, std::size_t elements);
set_scratch take_scratch(bump_allocator &from, const kind_info &kind, std::size_t elements);

// Fills a set whose memory was taken for this kind and number of elements. counterpart: null, or a filled set. Throws only
// where it is cancelled.
status fill(element_set &set, const view &elements, const pose &at, const set_scratch &scratch, const execution &on,
            const element_set *counterpart = nullptr);

// Fills a set in the order of `ordered`, from the places of its elements now. `slots`: with an index, whose vertices are there,
// that of the elements in this order; without, the rows of all in the caller's order. of_points: where the elements are nothing
// but points, which lie in the pose already, their magnitudes; else null. Returns ok, or bad_value where an element is bad.
// Throws only where it is cancelled.
status refit(element_set &set, const element_set &ordered, const view &slots, const pose &at,
             const magnitudes *of_points, const execution &on);

} // namespace meetc

#endif
