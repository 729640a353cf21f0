// core/device/repeated.hpp: a sequence of kernels that is asked for again and again starts as one.
//
// Problem: a query starts some ten kernels, which takes a host 4 us each, and a small query's kernels take less than that.
// Method: when a sequence is asked for the second time it is captured as a CUDA graph, which is launched from then on. Two
// sequences are the same if their keys are equal, so that a key holds all that the arguments of the launches are made of.
// Limits: of the last few sequences. Where a sequence cannot be captured, it is enqueued each time. While one is being captured,
// CUDA refuses to other threads what waits for the whole device, as cudaDeviceSynchronize() does.
#ifndef MEETC_CORE_DEVICE_REPEATED_HPP
#define MEETC_CORE_DEVICE_REPEATED_HPP

#include <cuda_runtime_api.h>

#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace meetc {

// Addresses and numbers, one after another.
class launch_key {
public:
  template <class... Values> void add(const Values &...values) { (add_one(values), ...); }
  bool operator==(const launch_key &) const = default;

private:
  template <class T> void add_one(const T &value) {
    if constexpr (std::is_pointer_v<T>)
      parts_.push_back(reinterpret_cast<std::uintptr_t>(value));
    else
      parts_.push_back(static_cast<std::uint64_t>(value));
  }
  std::vector<std::uint64_t> parts_;
};

class repeated_launches {
public:
  repeated_launches() = default;
  repeated_launches(const repeated_launches &) = delete;
  repeated_launches &operator=(const repeated_launches &) = delete;
  ~repeated_launches();

  // Enqueues on the stream what enqueue() enqueues on it, which is the same for equal keys: kernels, and memory set or copied on
  // the device. Throws what enqueue() throws, and device_error.
  void run(cudaStream_t stream, launch_key key, const std::function<void()> &enqueue);
  // A number that is kept with a key, of the last few that were asked for; 0 at first.
  std::uint64_t &note(const launch_key &key);

private:
  struct sequence {
    launch_key key;
    bool seen_twice;
    cudaGraphExec_t graph; // null: it has not been captured, or cannot be
  };
  std::vector<sequence> last_; // the latest at the end, as of the notes
  std::vector<std::pair<launch_key, std::uint64_t>> notes_;
};

} // namespace meetc

#endif
