// core/device/walk/first_walk.hpp: the walk of segments that go down alone, each to what it meets first.
#ifndef MEETC_CORE_DEVICE_WALK_FIRST_WALK_HPP
#define MEETC_CORE_DEVICE_WALK_FIRST_WALK_HPP

#include "meet/core/device/set/rows.hpp"

#include <optional>

namespace meetc {

// Whether it is expected to take less time than the walk of warps: a thread takes long for its segment, so that this needs as
// many as keep the device busy.
bool first_alone_pays(const device_rows &a);

// The walk of two sets with elements, but for its part and its lists; none where the rung or the sets do not allow it. Makes
// hierarchies where there are none; enqueues, and throws device_error.
std::optional<cuda::first_walk_job> first_walk_of(const device &on, device_rows &a, device_rows &b,
                                                  const cuda::predicate_launchers &by, rung precision);

// The slots of nodes of level 0, of which there are some.
cuda::part slots_of(const cuda::part &nodes, std::uint32_t elements_a, std::uint32_t elements_b);

} // namespace meetc

#endif
