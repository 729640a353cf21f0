// core/sets/topology.hpp: facts about a set that no pose changes: its connected parts, and whether it is closed.
//
// Corners are one where their coordinates are equal (0 and -0 are), as they then are in every pose.
#ifndef MEETC_CORE_SETS_TOPOLOGY_HPP
#define MEETC_CORE_SETS_TOPOLOGY_HPP

#include "meet/core/sets/element_set.hpp"

#include <mutex>
#include <optional>
#include <vector>

namespace meetc {

struct set_topology {
  // A point of the hull of an element.
  struct corner {
    std::uint32_t slot;
    int point;
  };
  // For each connected part, its corner with the least coordinates. Elements with a common corner are in one part; elements
  // that only touch may be in two. None for a kind without a hull.
  std::vector<corner> parts;
  // The least element with an edge that has not as many elements one way as the other, where elements have three points. None:
  // the set goes around each point a whole number of times.
  std::optional<std::uint32_t> open;
};

// The set holds all elements.
set_topology topology_of(const element_set &set, const execution &on = 1);

// The coordinates of a point of a row's hull.
void hull_point(const kind_info &kind, const float *row, int point, float out[3]);

// The topology of one set, found when asked for. Any thread may ask; after a call that was cancelled the next one finds it.
class kept_topology {
public:
  const set_topology &of(const element_set &set, const execution &on = 1) {
    std::call_once(once_, [&] { found_ = topology_of(set, on); });
    return found_;
  }

private:
  std::once_flag once_;
  set_topology found_;
};

} // namespace meetc

#endif
