// core/query/self_pairs.hpp: where a mesh crosses itself: the pairs of its elements that meet beyond their common corners.
//
// A pair i < j without a common corner counts if the elements touch, a pair with three common corners always, since it is one
// element twice. A pair with one or two common corners is asked of a predicate that leaves these corners out. Such neighbours,
// nearly all pairs of a mesh, come from its own corners: the hierarchy yields the others alone. The answers are exact.
#ifndef MEETC_CORE_QUERY_SELF_PAIRS_HPP
#define MEETC_CORE_QUERY_SELF_PAIRS_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/sets/prepared.hpp"

#include <functional>
#include <span>
#include <vector>

namespace meetc {

// Three predicates of one kind with three points. Those of neighbours find the common corners first in both operands, in the
// same order (algebra_spec/predicates/beyond.toml).
struct self_predicates {
  const predicate_info &apart, &one_common, &two_common;
};

struct self_options {
  int threads = 0; // 0: all cores
  // Corners with equal coordinates are one, as in a file without vertices. Else corners are one if their index is: sheets
  // that lie on each other then meet.
  bool merge = true;
  // As in collide_options: no pair of elements of one item counts. Common corners are those of elements: where items share a
  // border of three corners in line, and are cut into elements otherwise there, these elements meet beyond their corners.
  std::span<const std::uint32_t> owner = {};
  std::function<void(double fraction)> progress = {};
  std::stop_token stop = {}; // as in collide_options
};

struct self_result {
  std::vector<index_pair> pairs; // elements a < b, sorted by a, then b
  std::vector<std::uint32_t>
      degenerate;               // the elements whose corners lie on one line, sorted; their pairs count like all others
  std::uint64_t candidates = 0; // pairs without a common corner that were decided
  std::uint64_t neighbours[3] = {}; // pairs with one, two and three common corners
  rung_report rungs;                // of all pairs that were decided
  double seconds = 0;
};

// The mesh as it lies in `set`, which was prepared from this view. Memory grows with the elements and with the pairs found.
// Throws usage_error (a set that is not whole, another view, other kinds), std::out_of_range (an index that is not
// there), std::length_error (2^32 corners), std::bad_alloc or `cancelled`.
self_result self_pairs(const prepared &set, const view &elements, const self_predicates &predicates,
                       const self_options &options = {});

} // namespace meetc

#endif
