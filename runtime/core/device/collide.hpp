// core/device/collide.hpp: which elements of two sets touch, on a CUDA device. The answers are those of
// core/query/collide.hpp.
//
// The device finds pairs, and counts them, for each element too where that is asked for. Where there are owners, flags and
// counts of items are made on the host from the list of pairs, so that their memory grows with the pairs.
//
// The elements of one set walk down a hierarchy of boxes over the other, which finds candidates: its cost grows with the
// sets and with these. The reject stage and the rungs follow, each from one list to the next. Where a list would overflow,
// the walk is cut into parts, so memory is bounded for any number of candidates and nothing is lost.
//
// result::candidates counts pairs whose boxes, or two points where those were tested, touch, or are not proved to be apart.
// A walk of balls compares these as well, so that there are fewer than on the CPU; it decides nearly all pairs itself, and
// those never count as unsure.
//
// A set may be collided with itself. If the predicate is symmetric and the rung is never wrong, only half of the pairs are
// tested, and their hits are turned round; rungs.unsure then counts that half.
#ifndef MEETC_CORE_DEVICE_COLLIDE_HPP
#define MEETC_CORE_DEVICE_COLLIDE_HPP

#include "meet/core/device/answers/device_result.hpp"
#include "meet/core/device/set/device_set.hpp"
#include "meet/core/query/collide.hpp"

namespace meetc {

// Throws what collide() on the CPU throws, device_error, and what is wrong with a given set, of A before B, as the
// constructor of a set in order does.
device_result collide(const device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {});

} // namespace meetc

#endif
