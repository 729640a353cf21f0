// core/device/search.hpp: the ways in which a device finds candidates, and what each is expected to cost.
#ifndef MEETC_CORE_DEVICE_SEARCH_HPP
#define MEETC_CORE_DEVICE_SEARCH_HPP

#include <cstdint>

namespace meetc {

enum class search : std::uint8_t {
  every_pair, // the filter, of all pairs of elements
  groups,     // the filter, of all pairs of groups of neighbours
  tree,       // a walk down a hierarchy
};
inline constexpr int searches = 3;
const char *name_of(search s);

// Seconds until the candidates are found, by search.
struct search_costs {
  double of[searches] = {0, 0, 0};
  search least() const;
};

// What two sets say about that.
struct search_sizes {
  std::uint64_t a = 0, b = 0;          // elements
  bool made_a = false, made_b = false; // their hierarchies exist for the rows as they stand
  bool long_elements = false;          // a kind has two points, around which a ball is mostly empty
  bool balls = false;                  // a walk compares balls, of which fewer go down together first
};

// The model: a time to start, one for each pair of objects, and one for each element that is enclosed, gets columns, walks, or is
// taken from its group to be tested: a group of the larger set touches a few of the smaller, however far apart these lie. Where
// balls may be mostly empty, the filter is expected to pass every pair. Its constants were fitted by hand to times on an H200, of
// the scenes of `meet bench gpu --only growth`, and those of walks of balls on an H100; on other devices only their ratios matter.
search_costs expected_costs(const search_sizes &s);

} // namespace meetc

#endif
