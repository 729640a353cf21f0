// core/device/query.hpp: one query, of which collide() and collide_poses() are made.
#ifndef MEETC_CORE_DEVICE_QUERY_HPP
#define MEETC_CORE_DEVICE_QUERY_HPP

#include "core/device/collide.hpp"

#include <span>

namespace meetc {

// Throws std::invalid_argument where the sets, the predicate and the options do not go together.
void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options);

// collide() after require_query(), whose B may be several instances of equally many elements, one after another. If
// of_instances is not empty, it becomes the number of pairs of each, and nothing else is kept.
device_result query(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                    const device_options &options, std::span<std::uint64_t> of_instances);

} // namespace meetc

#endif
