// core/device/first_met.hpp: of each element of a set on a device, the element of another one that it meets first, found
// without a list of pairs on the host.
#ifndef MEETC_CORE_DEVICE_FIRST_MET_HPP
#define MEETC_CORE_DEVICE_FIRST_MET_HPP

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/set.hpp"
#include "meet/core/query/collide.hpp"
#include "meetc/cuda/table.hpp"

#include <span>

namespace meetc {

// All members enqueue their work on the device's stream, finish() waits for it, and all throw device_error.
class first_met_there {
public:
  explicit first_met_there(device_buffers &room) : slots_(room.first_slots), numbers_(room.first_numbers) {}

  // Of b's elements; the kernels were generated with an order.
  void start(const device_set &a, cudaStream_t stream);
  // Looks at n hits, pairs of slots. `owner_b`, in device memory: the items of b's elements, or null.
  void add(const cuda::predicate_launchers &by, const device_set &a, const device_set &b, const std::uint32_t *owner_b,
           const index_pair *hits, std::size_t n, cudaStream_t stream);
  // Names a's elements, and b's, by their numbers.
  void name(const device_set &a, const device_set &b, cudaStream_t stream);
  // Fills result::first_met. owner_b: the items of b's elements, or empty.
  void finish(const device_set &a, const device_set &b, std::span<const std::uint32_t> owner_b, result &r,
              cudaStream_t stream);

private:
  device_memory<std::uint32_t> &slots_, &numbers_; // slots of b by slots of a; numbers by numbers
};

} // namespace meetc

#endif
