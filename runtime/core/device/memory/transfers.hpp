// core/device/memory/transfers.hpp: memory that goes to a device and back.
//
// Problem: a device copies ordinary memory through a buffer of the driver, at a fraction of what the bus carries.
// Method: blocks go through buffers that the device reads and writes itself (pinned). Some threads fill or empty theirs while
// others' are on their way.
// Limits: less than a few blocks go as they are, and all memory where no buffers can be had.
#ifndef MEETC_CORE_DEVICE_MEMORY_TRANSFERS_HPP
#define MEETC_CORE_DEVICE_MEMORY_TRANSFERS_HPP

#include <cuda_runtime_api.h>

#include <cstddef>
#include <vector>

namespace meetc {

class transfers {
public:
  transfers() = default;
  transfers(const transfers &) = delete;
  transfers &operator=(const transfers &) = delete;
  ~transfers();

  // Enqueues. The host's memory, which is not pinned, may be changed as soon as this returns. Throws device_error, as does
  // download().
  void upload(void *there, const void *here, std::size_t bytes, cudaStream_t stream, const char *what);
  // Waits for the stream, and until the bytes are here.
  void download(void *here, const void *there, std::size_t bytes, cudaStream_t stream, const char *what);

private:
  struct buffer {
    std::byte *pinned;
    cudaEvent_t free;
  };
  // The number of workers that have two buffers each; 0 where the driver has none.
  int take_buffers();

  std::vector<buffer> buffers_;
  bool refused_ = false;
};

} // namespace meetc

#endif
