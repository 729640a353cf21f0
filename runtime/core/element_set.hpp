// core/element_set.hpp: a prepared set: rows in spatial order, and the hierarchy of their boxes.
//
// A slot is a position in that order; `order` maps it to the caller's element. Rows lie in the order of slots, so that
// the rows of one block are read together.
#ifndef MEETC_CORE_ELEMENT_SET_HPP
#define MEETC_CORE_ELEMENT_SET_HPP

#include "core/hierarchy.hpp"
#include "core/morton.hpp"
#include "core/pose.hpp"
#include "core/status.hpp"
#include "core/view.hpp"

namespace meetc {

struct element_set {
  const kind_info *kind = nullptr;
  std::size_t elements = 0;
  float *rows = nullptr;
  std::uint32_t *order = nullptr;
  // The largest |coordinate| and |length| of any row; infinite if a field is neither.
  float reach = 0, longest = 0;
  hierarchy boxes;
};

// Memory that is needed to build a set and not kept.
struct set_scratch {
  float *rows = nullptr;
  centre *centres = nullptr;
  std::uint64_t *keys = nullptr, *more_keys = nullptr;
};

element_set take_set(bump_allocator &from, const kind_info &kind, std::size_t elements);
set_scratch take_scratch(bump_allocator &from, const kind_info &kind, std::size_t elements);

// Fills a set whose memory was taken for this kind and number of elements.
status fill(element_set &set, const view &elements, const pose &at, const set_scratch &scratch, int threads);

} // namespace meetc

#endif
