// core/device/query/query.hpp: one query on rows that are in order, of which collide() is made.
#ifndef MEETC_CORE_DEVICE_QUERY_QUERY_HPP
#define MEETC_CORE_DEVICE_QUERY_QUERY_HPP

#include "meet/core/device/query/decide.hpp"
#include "meet/core/device/set/device_set.hpp"

namespace meetc {

// Throws device_error where there are none.
const cuda::predicate_launchers &launchers_of(const cuda::catalogue &all, const predicate_info &p);

// Throws usage_error where the sets, the predicate and the options do not go together.
void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options);

// After require_query(). `clock_runs`: the caller has started the clock of device_seconds and has cleared the device's counts.
device_result query(const device &on, device_rows &a, device_rows &b, const predicate_info &predicate, rung precision,
                    const device_options &options, device_answers answers, bool clock_runs = false);

} // namespace meetc

#endif
