// core/device/device.hpp: one CUDA device, found and tested.
//
// Nothing here starts CUDA before a device is made. Errors are device_error, one line that names the operation and a
// way out.
#ifndef MEETC_CORE_DEVICE_DEVICE_HPP
#define MEETC_CORE_DEVICE_DEVICE_HPP

#include "meetc/cuda/table.hpp"

#include <memory>
#include <stdexcept>
#include <string>

namespace meetc {

class device_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

struct device_facts {
  std::string name;
  int major = 0, minor = 0; // compute capability, at least 8.0
  int multiprocessors = 0;
  std::size_t bytes = 0;
};

// Why the device that was found cannot be used, in one line; empty where it can. `driver` is the CUDA version of the
// driver, 0 where there is none; `found` is the device, if `count` is not 0.
std::string refusal(cudaError_t looking, int count, int driver, const device_facts &found);

struct device_buffers;

// The current CUDA device, with a stream and buffers that queries share; it runs one query at a time. Uploaded sets
// must not outlive it. While it exists, the process's default pool of device memory keeps what is freed.
class device {
public:
  // Throws device_error where there is no device, where it or its driver is too old, or where its arithmetic is not as
  // the bounds assume.
  explicit device(const cuda::catalogue &kernels);
  ~device();
  device(const device &) = delete;
  device &operator=(const device &) = delete;

  const cuda::catalogue &kernels() const { return kernels_; }
  const device_facts &facts() const { return facts_; }
  cudaStream_t stream() const;
  device_buffers &buffers() { return *buffers_; }

private:
  const cuda::catalogue &kernels_;
  device_facts facts_;
  void keep_freed_memory();

  cudaMemPool_t pool_ = nullptr;  // null: there is none
  std::uint64_t kept_before_ = 0; // what the pool kept of freed memory, in bytes
  std::unique_ptr<device_buffers> buffers_;
};

// Throws device_error with the name of the call and the text that CUDA gives for the error.
void check(cudaError_t e, const char *what);

} // namespace meetc

#endif
