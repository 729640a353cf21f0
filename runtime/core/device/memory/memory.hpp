// core/device/memory/memory.hpp: device memory that frees itself and grows.
#ifndef MEETC_CORE_DEVICE_MEMORY_MEMORY_HPP
#define MEETC_CORE_DEVICE_MEMORY_MEMORY_HPP

#include "meet/core/device/memory/device.hpp"

#include <utility>

namespace meetc {

// Throws device_error with the sizes where there is too little memory.
void *allocate_on_device(std::size_t bytes, const char *what_for);
// Returns null where there is too little memory.
void *try_allocate_on_device(std::size_t bytes);
// Waits for all that the device has to do. Null is nothing. An error is told by the next check().
void free_on_device(void *data) noexcept;

// Uninitialised memory for objects of a trivial type.
template <class T> class device_memory {
public:
  device_memory() = default;
  device_memory(device_memory &&other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)) {}
  device_memory &operator=(device_memory &&other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~device_memory() { release(); }

  T *data() const { return data_; }
  std::size_t capacity() const { return capacity_; }

  void release() {
    free_on_device(data_);
    data_ = nullptr;
    capacity_ = 0;
  }

  // Returns room for n objects. If it has to grow, its content is lost.
  T *reserve(std::size_t n, const char *what_for) {
    if (n > capacity_) {
      release();
      data_ = static_cast<T *>(allocate_on_device(n * sizeof(T), what_for));
      capacity_ = n;
    }
    return data_;
  }

  // Makes room for n objects and keeps the first `used`. Returns false, with nothing changed, where there is too little
  // memory.
  bool grow(std::size_t n, std::size_t used, cudaStream_t stream) {
    if (n <= capacity_)
      return true;
    auto *more = static_cast<T *>(try_allocate_on_device(n * sizeof(T)));
    if (!more)
      return false;
    device_memory old(std::exchange(data_, more), std::exchange(capacity_, n));
    if (used > 0)
      check(cudaMemcpyAsync(data_, old.data_, used * sizeof(T), cudaMemcpyDeviceToDevice, stream), "growing a list");
    check(cudaStreamSynchronize(stream), "growing a list"); // before the old memory is freed
    return true;
  }

private:
  device_memory(T *data, std::size_t capacity) : data_(data), capacity_(capacity) {}
  T *data_ = nullptr;
  std::size_t capacity_ = 0;
};

} // namespace meetc

#endif
