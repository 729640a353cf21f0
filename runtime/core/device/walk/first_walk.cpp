#include "meet/core/device/walk/first_walk.hpp"

#include "meet/core/device/memory/buffers.hpp"

#include <algorithm>

namespace meetc {

bool first_alone_pays(const device_rows &a) {
  return a.elements() >= std::uint32_t{1} << 17;
}

std::optional<cuda::first_walk_job> first_walk_of(const device &on, device_rows &a, device_rows &b,
                                                  const cuda::predicate_launchers &by, rung precision) {
  if (!by.pairs.walk_first || !never_wrong(precision))
    return {};
  const std::optional<cuda::fours_view> tree = b.fours(on.stream());
  if (!tree)
    return {};
  cuda::first_walk_job job{};
  job.a = a.data(), job.b = b.data(), job.tree = *tree;
  job.taken = on.buffers().count_of(counter::taken), job.decided = on.buffers().count_of(counter::touching);
  job.found_a = a.findings(), job.found_b = b.findings();
  job.elements_a = a.elements();
  return job;
}

cuda::part slots_of(const cuda::part &nodes, std::uint32_t elements_a, std::uint32_t elements_b) {
  const auto slot = [](std::uint32_t node, std::uint32_t elements) {
    return static_cast<std::uint32_t>(std::min(std::uint64_t{node} * cuda::tree_width, std::uint64_t{elements}));
  };
  return {slot(nodes.first_a, elements_a), slot(nodes.end_a, elements_a), slot(nodes.first_b, elements_b),
          slot(nodes.end_b, elements_b)};
}

} // namespace meetc
