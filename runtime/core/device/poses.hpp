// core/device/poses.hpp: one set against another in many poses, on a CUDA device.
//
// Problem: a query takes some 50 us even where nothing touches, and its kernels are too short to fill a device. Method: the
// elements of B in many poses at once are one set, whose hierarchy's lowest boxes each hold neighbours in one pose or two, and
// one query counts the pairs of each pose. A pose in which the box around B is proved apart from that around A is not looked
// at. As many poses are taken at once as memory allows, and as will probably not overflow the lists. Where it is only asked
// whether anything touches, a sixteenth of B's elements goes first, and all of them in the poses that are left.
#ifndef MEETC_CORE_DEVICE_POSES_HPP
#define MEETC_CORE_DEVICE_POSES_HPP

#include "meet/core/device/collide.hpp"

#include <span>
#include <vector>

namespace meetc {

struct poses_result {
  // For each pose, how many pairs (a, b) touch; for answer_kind::any 1 if one does, and 0 if not.
  std::vector<std::uint64_t> counts;
  // The counts of all poses; for answer_kind::any also of the sixteenth of B that went first.
  rung_report rungs;
  std::uint64_t candidates = 0;
  double device_seconds = 0, seconds = 0; // as in device_result; without posing, and with it
};

// Each count is that of collide() on a and b in that pose, which replaces the pose of b for this call alone. Among the options,
// owners are not read, and `want` is count or any. Throws what collide() throws, std::invalid_argument for other answers,
// and what device_set::move() throws for a pose, with its number in the text; poses count from 0. With answer_kind::any an
// element that leaves float32 in a pose is no error where a sixteenth of the elements has told that the pose touches, and
// one that breaks a rule of its kind is none where the pose is proved to keep the sets apart.
poses_result collide_poses(const device &on, device_set &a, const device_set &b, std::span<const pose> poses,
                           const predicate_info &predicate, rung precision, const device_options &options = {});

// Bodies against bodies in many configurations, each of which has a pose for every body of B. poses[k * b.size() + j] is
// that of body j in configuration k. counts[i * poses.size() + k * b.size() + j] of the result is that of collide_poses()
// for body i of A and that pose. Throws what that throws, with a pose's place in `poses`, and std::invalid_argument where a
// configuration lacks poses.
poses_result collide_bodies(const device &on, std::span<device_set *const> a, std::span<const device_set *const> b,
                            std::span<const pose> poses, const predicate_info &predicate, rung precision,
                            const device_options &options = {});

} // namespace meetc

#endif
