// core/device/self_pairs.hpp: where a mesh crosses itself, on a CUDA device. The pairs are those of core/query/self_pairs.hpp.
//
// A walk of the set with itself lists the pairs whose boxes touch, all neighbours among them, since a common corner lies in
// both boxes. A kernel sorts them by their common corners, whose numbers are made on the device: pairs without one go to the
// predicate of two elements, neighbours to that of their number of common corners, and no pair is looked at by two. Corners are
// found anew in each call, from the rows as they lie there, so that a set may have been moved.
#ifndef MEETC_CORE_DEVICE_SELF_PAIRS_HPP
#define MEETC_CORE_DEVICE_SELF_PAIRS_HPP

#include "meet/core/device/answers/device_result.hpp"
#include "meet/core/device/set/device_set.hpp"
#include "meet/core/query/self_pairs.hpp"

namespace meetc {

struct device_self_options {
  // As in self_options. Unmerged corners are one if their vertices are: three of each element; empty: no two corners are one.
  bool merge = true;
  std::span<const std::uint32_t> vertices = {};
  std::span<const std::uint32_t> owner = {};
  pairs_there *leave_there = nullptr;               // as in device_options
  std::size_t list_capacity = std::size_t{1} << 25; // likewise
  std::function<void(double fraction)> progress = {};
  std::stop_token stop = {}; // as in device_options
};

struct device_self_result : self_result {
  std::uint64_t parts = 0; // as in device_result
  double device_seconds =
      0; // likewise; a given set is ordered before, and elements without extent are confirmed afterwards
};

// `neighbours` has the launchers of one_common and two_common, and the device's own catalogue those of `apart`. Takes some 330
// bytes an element while it runs. rungs.unsure may count fewer pairs in fp32 than on the CPU. Throws usage_error (a
// set on another device, other kinds, vertices or an owner map of another length), std::length_error (a third of 2^31
// elements), device_error, and for a given set what collide() throws.
device_self_result self_pairs(const device &on, device_set &mesh, const self_predicates &predicates,
                              const cuda::catalogue &neighbours, const device_self_options &options = {});

} // namespace meetc

#endif
