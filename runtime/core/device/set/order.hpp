// core/device/set/order.hpp: puts the given sets of a query into order.
#ifndef MEETC_CORE_DEVICE_SET_ORDER_HPP
#define MEETC_CORE_DEVICE_SET_ORDER_HPP

#include "meet/core/device/set/device_set.hpp"

#include <span>

namespace meetc {

// The elements of a given set that a query needs: all of them, or those that culling has left.
struct needed_elements {
  device_set *of;
  cuda::view elements;
};

// One set or two. Makes their hierarchies too, both at once; only enqueues, on the device's streams. `common` is that of
// order_request. Starts the clock unless it runs, and clears the counts of the device's buffers, whose `found` becomes what
// is found of each. Throws device_error.
void order(const device &on, std::span<const needed_elements> sets, const cuda::joined_box *common, bool clock_runs);

// Whether all are in order, by what a query has read of the device's notes.
bool are_in_order(const device &on, std::span<const needed_elements> sets);

} // namespace meetc

#endif
