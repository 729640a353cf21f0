// core/traversal/candidate_operand.hpp: what rules candidates out, and a set in a query for candidates.
#ifndef MEETC_CORE_TRAVERSAL_CANDIDATE_OPERAND_HPP
#define MEETC_CORE_TRAVERSAL_CANDIDATE_OPERAND_HPP

#include "meet/core/hierarchy/two_points.hpp"
#include "meet/core/sets/element_set.hpp"

namespace meetc {

// The test that rules a pair out. The answers of exact and certified do not depend on it. A plain rung may say yes where
// nothing touches, so its answer is about the pairs whose boxes touch, on a device as well.
enum class ruled_out_by : std::uint8_t { boxes, boxes_and_points };

inline ruled_out_by what_rules_out(rung precision) {
  return never_wrong(precision) ? ruled_out_by::boxes_and_points : ruled_out_by::boxes;
}

// A set as an operand of a query.
struct candidate_operand {
  const element_set &set;
  bool by_points; // its elements are tested by their two points

  candidate_operand(const element_set &s, ruled_out_by what)
      : set(s), by_points(what == ruled_out_by::boxes_and_points && has_two_points(*s.kind)) {}
};

} // namespace meetc

#endif
