// core/device/collide.hpp: which elements of two sets touch, on a CUDA device. The answers are those of
// core/query/collide.hpp.
//
// The device finds pairs, and counts them, for each element too where that is asked for. Where there are owners, flags and
// counts of items are made on the host from the list of pairs, so that their memory grows with the pairs.
//
// The elements of one set walk down a hierarchy of boxes over the other, which finds candidates: its cost grows with the sets and
// with these. The reject stage and the rungs follow, each from one list to the next. Where a list would overflow, the walk is cut
// into parts, so memory is bounded for any number of candidates and nothing is lost.
//
// result::candidates counts pairs whose boxes, or two points where those were tested, touch, or are not proved to be apart. A walk
// of balls compares these as well, so that there are fewer than on the CPU; it decides nearly all pairs itself, and those never
// count as unsure.
//
// A set may be collided with itself. If the predicate is symmetric and the rung is never wrong, only half of the pairs are tested,
// and their hits are turned round; rungs.unsure then counts that half.
#ifndef MEETC_CORE_DEVICE_COLLIDE_HPP
#define MEETC_CORE_DEVICE_COLLIDE_HPP

#include "meet/core/device/set.hpp"

#include <optional>

namespace meetc {

struct device_options {
  answer_kind want = answer_kind::pairs;
  // The item of each element; empty: each element is its own item. Answers are then about items, as in collide_options.
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  bool first_met = false; // as in collide_options; the device's kernels must have been generated with the order as well
  // Of sets as they are given (given.hpp): elements that cannot touch are left out before the others are put into order. Empty:
  // where this is expected to pay.
  std::optional<bool> cull = {};
  std::size_t list_capacity = std::size_t{1} << 25; // pairs in a list, at least 2^11
  std::function<void(double fraction)> progress = {};
};

struct device_result : result {
  std::uint64_t parts = 0; // parts of the walk that were run
  // From the first kernel to the last, with the allocations between them; without uploading sets, and without
  // downloading pairs where the device had the memory to sort them.
  double device_seconds = 0;
};

// A sorted list of pairs that lies on a device, until the next query there, and no longer than the device. Null where there is
// none: the result has the pairs then, if they were asked for.
struct pairs_there {
  index_pair *pairs = nullptr;
  std::size_t n = 0;
};

// Throws what collide() on the CPU throws, and device_error.
device_result collide(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {});

} // namespace meetc

#endif
