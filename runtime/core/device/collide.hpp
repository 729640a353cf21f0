// core/device/collide.hpp: which elements of two sets touch, on CUDA devices: on one, in many poses at once, or between several
// (core/device/group.hpp). The answers are those of core/query/collide.hpp.
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
#include "meet/core/device/group.hpp"
#include "meet/core/device/set/device_set.hpp"
#include "meet/core/query/collide.hpp"

#include <span>
#include <vector>

namespace meetc {

// Throws what collide() on the CPU throws, device_error, and what is wrong with a given set, of A before B, as the
// constructor of a set in order does.
device_result collide(const device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {});

// One set is cut and the other whole; what is met first is asked of a set that is cut. Throws what collide() on one device
// throws, and usage_error for options.leave_there. In the result, seconds are the host's wall clock,
// device_seconds those of the device that took longest, candidates, parts and rungs are summed. options.progress tells of
// the first device.
device_result collide(const device_group &on, group_set &a, group_set &b, const predicate_info &predicate,
                      rung precision, const device_options &options = {});

struct poses_result {
  // For each pose, how many pairs (a, b) touch; for answer_kind::any 1 if one does, and 0 if not.
  std::vector<std::uint64_t> counts;
  // The counts of all poses; for answer_kind::any also of the sixteenth of B that went first.
  rung_report rungs;
  std::uint64_t candidates = 0;
  double device_seconds = 0, seconds = 0; // as in device_result; without posing, and with it
};

// Each count is that of collide() on a and b in that pose, which replaces the pose of b for this call alone. Among the options,
// owners are not read, and `want` is count or any. Throws what collide() throws, usage_error for other answers,
// and what device_set::move() throws for a pose, with its number in the text; poses count from 0. With answer_kind::any an
// element that leaves float32 in a pose is no error where a sixteenth of the elements has told that the pose touches, and
// one that breaks a rule of its kind is none where the pose is proved to keep the sets apart.
poses_result collide(const device &on, device_set &a, const device_set &b, std::span<const pose> poses,
                     const predicate_info &predicate, rung precision, const device_options &options = {});

// Bodies against bodies in many configurations, each of which has a pose for every body of B. poses[k * b.size() + j] is
// that of body j in configuration k. counts[i * poses.size() + k * b.size() + j] of the result is that of collide()
// for body i of A and that pose. Throws what that throws, with a pose's place in `poses`, and usage_error where a
// configuration lacks poses.
poses_result collide(const device &on, std::span<device_set *const> a, std::span<const device_set *const> b,
                     std::span<const pose> poses, const predicate_info &predicate, rung precision,
                     const device_options &options = {});

} // namespace meetc

#endif
