// How kernels are started on the host: at once, by the threads of host_warp.hpp, some blocks after another. The device has
// three multiprocessors, each of which runs one block at a time; only blocks that may wait for each other run at once.
//
// Read before all else in each source of device code that is compiled for the host.
#ifndef MEETC_TESTS_HOST_LAUNCH_HPP
#define MEETC_TESTS_HOST_LAUNCH_HPP

#include "tests/runtime/device/host/host_warp.hpp"

#include <cfenv>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <vector_types.h>

#undef __launch_bounds__
#define __launch_bounds__(...)
using std::isfinite;

namespace host_warp {

inline std::mutex one_kernel; // what it uses is of the whole program
inline constexpr int multiprocessors = 3;
inline std::map<const void *, std::size_t> shared_memory_of; // kernels that asked for more than they have unasked
inline constexpr std::size_t shared_memory_unasked = 49152;

// A device's arithmetic does not depend on the control word of the thread that starts a kernel.
class arithmetic_of_device {
public:
  arithmetic_of_device() { std::fegetenv(&found_), std::fesetenv(FE_DFL_ENV); }
  ~arithmetic_of_device() { std::fesetenv(&found_); }
  arithmetic_of_device(const arithmetic_of_device &) = delete;
  arithmetic_of_device &operator=(const arithmetic_of_device &) = delete;

private:
  std::fenv_t found_{};
};

} // namespace host_warp

template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t *how, void (*kernel)(Parameters...), Arguments &&...arguments) {
  const std::lock_guard lock(host_warp::one_kernel);
  const host_warp::arithmetic_of_device arithmetic;
  if (how->dynamicSmemBytes > host_warp::shared_memory_unasked &&
      how->dynamicSmemBytes > host_warp::shared_memory_of[reinterpret_cast<const void *>(kernel)])
    return cudaErrorInvalidValue;
  if (how->gridDim.x == 0 || how->blockDim.x == 0 || how->blockDim.x > 1024)
    return cudaErrorInvalidConfiguration;
  const bool together = how->numAttrs == 1 && how->attrs->id == cudaLaunchAttributeCooperative;
  if (together && how->gridDim.x > static_cast<unsigned>(host_warp::multiprocessors))
    return cudaErrorCooperativeLaunchTooLarge;
  const std::tuple<std::remove_const_t<Parameters>...> given(arguments...);
  gridDim = {how->gridDim.x}, blockDim = {how->blockDim.x};
  const unsigned at_once = together ? how->gridDim.x : 1;
  for (unsigned first = 0; first < how->gridDim.x; first += at_once) {
    host_warp::the_blocks.give_shared(at_once, how->dynamicSmemBytes);
    host_warp::the_blocks.run([&] { std::apply(kernel, given); }, how->blockDim.x, at_once, first);
  }
  return cudaSuccess;
}

template <class... Parameters> cudaError_t cudaFuncGetAttributes(cudaFuncAttributes *of, void (*)(Parameters...)) {
  *of = {};
  return cudaSuccess;
}
template <class... Parameters>
cudaError_t cudaFuncSetAttribute(void (*kernel)(Parameters...), cudaFuncAttribute, int bytes) {
  const std::lock_guard lock(host_warp::one_kernel);
  host_warp::shared_memory_of[reinterpret_cast<const void *>(kernel)] = static_cast<std::size_t>(bytes);
  return cudaSuccess;
}
template <class... Parameters>
cudaError_t cudaOccupancyMaxActiveBlocksPerMultiprocessor(int *blocks, void (*)(Parameters...), int, std::size_t) {
  *blocks = 1;
  return cudaSuccess;
}

namespace meetc::cuda {

inline void meet_grid() {
  host_warp::the_blocks.meet(host_warp::scope::grid, "grid", 0);
}
inline uint4 *shared_memory() {
  return reinterpret_cast<uint4 *>(host_warp::the_blocks.shared().data());
}

} // namespace meetc::cuda

namespace meetc {

// The host's arithmetic is tested elsewhere.
inline cudaError_t launch_self_test(unsigned *faults, cudaStream_t) {
  *faults = 0;
  return cudaSuccess;
}

} // namespace meetc

#endif
