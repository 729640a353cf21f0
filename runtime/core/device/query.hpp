// core/device/query.hpp: one query, of which collide() and collide_poses() are made.
#ifndef MEETC_CORE_DEVICE_QUERY_HPP
#define MEETC_CORE_DEVICE_QUERY_HPP

#include "meet/core/device/collide.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meetc {

// Throws device_error where there are none.
const cuda::predicate_launchers &launchers_of(const cuda::catalogue &all, const predicate_info &p);

// Throws std::invalid_argument where the sets, the predicate and the options do not go together.
void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options);

// collide() after require_query(), whose B may be several instances of equally many elements, one after another. If
// of_instances is not empty, it becomes the number of pairs of each, and nothing else is kept. Where `left_there` is not null, and
// pairs are asked for, their list is left on the device if it is there; else it is in the result. Where `cleared` has a value, the
// caller has started the clock of device_seconds, has taken the notes that order all hits, and has cleared so many numbers from
// the counters on, all on the query's stream.
device_result query(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                    const device_options &options, std::span<std::uint64_t> of_instances,
                    pairs_there *left_there = nullptr, std::optional<std::size_t> cleared = {});

// Room for n pairs, in which nothing is kept.
void make_room(std::vector<index_pair> &pairs, std::size_t n);

} // namespace meetc

#endif
