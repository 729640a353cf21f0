// core/device/collide.hpp: which elements of two sets touch, on a CUDA device; the answers of core/collide.hpp.
//
// The device finds pairs, and counts them. Flags and counts of elements are made on the host from the list of
// pairs, so their memory grows with the pairs, on the device and for a while on the host.
//
// First the filter looks at every pair of groups of neighbours, or of elements: a matrix product whose signs tell which
// enclosing balls may touch. Then, from list to list, come boxes and the reject stage, and the rungs. The product is cut
// into parts where a list would overflow, so that memory is bounded at any number of candidates; nothing is lost.
// result::candidates counts pairs whose boxes and balls touch: fewer than on the CPU where a ball rules out more, and so
// can rungs.unsure be; for the plain rungs, which can say yes where nothing touches, balls are around boxes, and both
// decide the same pairs.
#ifndef MEETC_CORE_DEVICE_COLLIDE_HPP
#define MEETC_CORE_DEVICE_COLLIDE_HPP

#include "core/device/set.hpp"

#include <optional>

namespace meetc {

struct device_options {
  answer_kind want = answer_kind::pairs;
  // Element -> item, of each side; empty: the element itself. Answers are then of items, as in
  // collide_options.
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  std::optional<cuda::filter> filter = {}; // nothing: the device's best
  cuda::grouping by = cuda::grouping::group;
  std::optional<cover> balls = {}; // nothing: around boxes for the plain rungs, see above; else around elements
  std::size_t list_capacity = std::size_t{1} << 25; // pairs that a list may hold; at least 2^18
  std::function<void(double fraction)> progress = {};
};

struct device_result : result {
  cuda::filter filter = cuda::filter::float32;
  std::uint64_t near_balls = 0; // pairs of objects that the filter let through
  std::uint64_t parts = 0;      // in which the product was gone through
  // From the first kernel to the last, with what is allocated between them; without uploading sets and downloading pairs,
  // where the device had the memory to sort them.
  double device_seconds = 0;
};

// Throws as collide() on the CPU, and device_error.
device_result collide(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {});

} // namespace meetc

#endif
