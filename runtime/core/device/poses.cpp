#include "core/device/poses.hpp"

#include "core/device/query.hpp"

#include <algorithm>
#include <chrono>

namespace meetc {
namespace {

constexpr std::size_t most_elements = std::size_t{1} << 23; // at once: more do not fill the device better
constexpr std::size_t bytes_of_element = 4096;              // with boxes, stored values and lists, and room to spare

} // namespace

poses_result collide_poses(device &on, device_set &a, const device_set &b, std::span<const pose> poses,
                           const predicate_info &predicate, rung precision, const device_options &options) {
  const auto start = std::chrono::steady_clock::now();
  device_options o = options;
  o.want = answer_kind::count;
  o.owner_a = o.owner_b = {};
  o.progress = {};
  const std::size_t room = std::min(most_elements, on.facts().bytes / bytes_of_element);
  const std::size_t at_once = std::max<std::size_t>(1, room / std::max<std::size_t>(b.elements(), 1));
  poses_result r;
  r.counts.resize(poses.size());
  for (std::size_t first = 0; first < poses.size(); first += at_once) {
    const std::size_t n = std::min(at_once, poses.size() - first);
    device_set instances(b, poses.subspan(first, n), first);
    const device_result part = query(on, a, instances, predicate, precision, o, std::span(r.counts).subspan(first, n));
    for (int i = 0; i < 3; ++i)
      r.rungs.unsure[i] += part.rungs.unsure[i];
    r.rungs.left_box_a |= part.rungs.left_box_a, r.rungs.left_box_b |= part.rungs.left_box_b;
    r.candidates += part.candidates;
    r.device_seconds += part.device_seconds;
    if (options.progress)
      options.progress(static_cast<double>(first + n) / static_cast<double>(poses.size()));
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace meetc
