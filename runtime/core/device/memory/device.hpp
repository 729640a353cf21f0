// core/device/memory/device.hpp: one CUDA device, found and tested.
//
// Nothing here starts CUDA before a device is made. Errors are device_error, one line that names the operation and a
// way out.
#ifndef MEETC_CORE_DEVICE_MEMORY_DEVICE_HPP
#define MEETC_CORE_DEVICE_MEMORY_DEVICE_HPP

#include "meetc/cuda/table.hpp"

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

namespace meetc {

class device_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};
// There is no device, or none of this number, or this one cannot be used: it or its driver is too old, or its arithmetic is
// not as the bounds assume.
class missing_device : public device_error {
public:
  using device_error::device_error;
};
// The device's memory does not suffice.
class device_memory_error : public device_error {
public:
  using device_error::device_error;
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

// The current CUDA device, with a stream and buffers that queries share. A copy is the same device, and a set has one, so
// that what a set needs lives as long as the set. While there is one, the process's default pool of device memory keeps what
// is freed.
//
// It runs one query at a time: threads that ask it at once wait for each other.
class device {
public:
  // Throws missing_device. The table must stay, as that of a generated namespace does.
  explicit device(const cuda::catalogue &kernels);

  const cuda::catalogue &kernels() const;
  const device_facts &facts() const;
  cudaStream_t stream() const;
  device_buffers &buffers() const;
  // Whoever works on its stream or with its buffers holds this lock, which a thread may take again.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> use() const;
  bool operator==(const device &) const = default;

private:
  struct state;
  std::shared_ptr<state> state_;
};

// Throws device_error, or device_memory_error, with the name of the call and the text that CUDA gives for the error. A free
// that has failed before, where nobody could be told, is told here.
void check(cudaError_t e, const char *what);

} // namespace meetc

#endif
