#include "core/device/device.hpp"

#include "core/device/buffers.hpp"
#include "meet/self_test.hpp"

namespace meet {
namespace {

constexpr const char *on_the_cpu = "; the CPU decides the same pairs (--device cpu)";

device_facts find() {
  int count = 0;
  const cudaError_t e = cudaGetDeviceCount(&count);
  if (e == cudaErrorInsufficientDriver) {
    int driver = 0;
    cudaDriverGetVersion(&driver);
    if (driver > 0)
      throw device_error("the CUDA driver is for CUDA " + std::to_string(driver / 1000) + "." +
                         std::to_string(driver % 1000 / 10) + " and this build needs " +
                         std::to_string(CUDART_VERSION / 1000) + "." + std::to_string(CUDART_VERSION % 1000 / 10) +
                         on_the_cpu);
  }
  if (e == cudaErrorInsufficientDriver || e == cudaErrorNoDevice || (e == cudaSuccess && count == 0))
    throw device_error(std::string("there is no CUDA device here") + on_the_cpu);
  check(e, "looking for a CUDA device");
  int which = 0;
  cudaDeviceProp p{};
  check(cudaGetDevice(&which), "choosing a CUDA device");
  check(cudaGetDeviceProperties(&p, which), "asking the CUDA device what it is");
  if (p.major < 8)
    throw device_error(std::string("the CUDA device ") + p.name + " has compute capability " + std::to_string(p.major) +
                       "." + std::to_string(p.minor) + " and 8.0 is needed" + on_the_cpu);
  return {p.name, p.major, p.minor, p.multiProcessorCount, p.totalGlobalMem};
}

} // namespace

void check(cudaError_t e, const char *what) {
  if (e == cudaSuccess)
    return;
  cudaGetLastError(); // what can be forgotten is
  throw device_error(std::string("CUDA: ") + what + ": " + cudaGetErrorString(e) + on_the_cpu);
}

void *try_allocate_on_device(std::size_t bytes) {
  void *data = nullptr;
  const cudaError_t e = cudaMalloc(&data, bytes > 0 ? bytes : 1);
  if (e == cudaErrorMemoryAllocation) {
    cudaGetLastError();
    return nullptr;
  }
  check(e, "allocating memory");
  return data;
}

void *allocate_on_device(std::size_t bytes, const char *what_for) {
  void *const data = try_allocate_on_device(bytes);
  if (data)
    return data;
  std::size_t free = 0, all = 0;
  cudaMemGetInfo(&free, &all);
  throw device_error("not enough device memory: " + std::to_string(bytes >> 20) + " MiB asked for " + what_for + ", " +
                     std::to_string(free >> 20) + " MiB free" + on_the_cpu);
}

device::device(const cuda::catalogue &kernels)
    : kernels_(kernels), facts_(find()), buffers_(std::make_unique<device_buffers>()) {
  device_memory<cuda::probe_result> found;
  found.reserve(1, "the start-up probe");
  check(kernels.probe(found.data(), nullptr), "starting the probe");
  check(cudaMemcpy(&probe_, found.data(), sizeof probe_, cudaMemcpyDeviceToHost), "the start-up probe");
  for (unsigned bit = 1; bit <= fault_bits; bit <<= 1)
    if (probe_.arithmetic_faults & bit)
      throw device_error(std::string("the CUDA device ") + facts_.name +
                         " does not compute as the error bounds assume: " + text_of(static_cast<arithmetic_fault>(bit)) +
                         on_the_cpu);
  check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
}

device::~device() {
  if (stream_)
    cudaStreamDestroy(stream_);
}

bool device::offers(cuda::filter f) const {
  const bool mma = probe_.cases > 0 && probe_.mma_faults == 0;
  switch (f) {
  case cuda::filter::float32:
    return true;
  case cuda::filter::mma:
    return mma;
  case cuda::filter::wgmma: // goes through hits again by mma.sync
    return mma && probe_.has_wgmma && probe_.wgmma_faults == 0;
  case cuda::filter::wgmma_half:
    return mma && probe_.has_wgmma && probe_.wgmma_half_faults == 0;
  }
  return false;
}

cuda::filter device::best_filter() const {
  for (const cuda::filter f : {cuda::filter::wgmma, cuda::filter::mma})
    if (offers(f))
      return f;
  return cuda::filter::float32;
}

const char *model_of(cuda::filter f) {
  switch (f) {
  case cuda::filter::float32:
    break;
  case cuda::filter::mma:
    return "mma-f16-f32";
  case cuda::filter::wgmma:
    return "wgmma-f16-f32";
  case cuda::filter::wgmma_half:
    return "wgmma-f16-f16";
  }
  return "none";
}

} // namespace meet
