// core/device/buffers.hpp: what queries on one device share, so that only the first allocates memory.
#ifndef MEETC_CORE_DEVICE_BUFFERS_HPP
#define MEETC_CORE_DEVICE_BUFFERS_HPP

#include "core/device/memory.hpp"

#include <cstdint>

namespace meetc {

// The lists of a query, named by what they count.
enum class counter : std::uint8_t { candidates, kept, touching, hits, unsure_fp32, unsure_fp64, unsure_fp64x2, unused };
inline constexpr int counters = 8;

struct device_buffers {
  device_memory<index_pair> first, second, hits; // first and second alternate for candidates and unsure pairs
  device_memory<unsigned long long> counts;
  device_memory<std::uint64_t> keys, more_keys; // hits as sortable numbers
  device_memory<std::byte> sort_space;
  cudaEvent_t events[2] = {nullptr, nullptr};
  unsigned long long *seen = nullptr; // the counts, in host memory that the device can write to

  ~device_buffers() {
    for (const cudaEvent_t e : events)
      if (e)
        cudaEventDestroy(e);
    cudaFreeHost(seen);
  }
};

} // namespace meetc

#endif
