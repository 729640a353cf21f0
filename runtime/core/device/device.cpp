#include "meet/core/device/device.hpp"

#include "meet/core/device/buffers.hpp"
#include "meetc/number/self_test.hpp"

namespace meetc {
namespace {

constexpr const char *on_the_cpu = "; the CPU decides the same pairs (--device cpu)";

std::string version(int v) {
  return std::to_string(v / 1000) + "." + std::to_string(v % 1000 / 10);
}

device_facts find() {
  int count = 0, driver = 0, which = 0;
  device_facts found;
  const cudaError_t looking = cudaGetDeviceCount(&count);
  cudaDriverGetVersion(&driver);
  if (looking == cudaSuccess && count > 0) {
    cudaDeviceProp p{};
    check(cudaGetDevice(&which), "choosing a CUDA device");
    check(cudaGetDeviceProperties(&p, which), "reading the properties of the CUDA device");
    found = {p.name, p.major, p.minor, p.multiProcessorCount, p.totalGlobalMem};
  }
  if (const std::string why = refusal(looking, count, driver, found); !why.empty())
    throw device_error(why);
  return found;
}

} // namespace

std::string refusal(cudaError_t looking, int count, int driver, const device_facts &found) {
  if (looking == cudaErrorInsufficientDriver && driver > 0)
    return "the CUDA driver is for CUDA " + version(driver) + " and this build needs " + version(CUDART_VERSION) +
           on_the_cpu;
  if (looking == cudaErrorInsufficientDriver || looking == cudaErrorNoDevice || (looking == cudaSuccess && count == 0))
    return std::string("there is no CUDA device here") + on_the_cpu;
  if (looking != cudaSuccess)
    return std::string("CUDA: looking for a device: ") + cudaGetErrorString(looking) + on_the_cpu;
  if (found.major < 8)
    return "the CUDA device " + found.name + " has compute capability " + std::to_string(found.major) + "." +
           std::to_string(found.minor) + " and 8.0 is needed" + on_the_cpu;
  return "";
}

void check(cudaError_t e, const char *what) {
  if (e == cudaSuccess)
    return;
  cudaGetLastError(); // clears an error that can be cleared
  throw device_error(std::string("CUDA: ") + what + ": " + cudaGetErrorString(e) + on_the_cpu);
}

// The process's pool keeps what is freed: a query allocates for each set that it sees, and the driver takes long for that.
void device::keep_freed_memory() {
  int number = 0;
  std::uint64_t all = ~std::uint64_t{0};
  if (cudaGetDevice(&number) == cudaSuccess && cudaDeviceGetDefaultMemPool(&pool_, number) == cudaSuccess &&
      cudaMemPoolGetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &kept_before_) == cudaSuccess &&
      cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &all) == cudaSuccess)
    return;
  cudaGetLastError(); // there are devices without a pool
  pool_ = nullptr;
}

void *try_allocate_on_device(std::size_t bytes) {
  const control_word_guard guard;
  void *data = nullptr;
  cudaError_t e = cudaMallocAsync(&data, bytes > 0 ? bytes : 1, nullptr);
  if (e == cudaSuccess) {
    e = cudaStreamSynchronize(nullptr); // from now on any stream may use it
  } else if (e == cudaErrorNotSupported) {
    cudaGetLastError();
    e = cudaMalloc(&data, bytes > 0 ? bytes : 1);
  }
  if (e == cudaErrorMemoryAllocation) {
    cudaGetLastError();
    return nullptr;
  }
  check(e, "allocating memory");
  return data;
}

void free_on_device(void *data) {
  if (!data)
    return;
  const control_word_guard guard;
  cudaDeviceSynchronize(); // memory of the pool may be in use
  cudaFree(data);          // an error here has been reported where it arose
}

void *allocate_on_device(std::size_t bytes, const char *what_for) {
  void *const data = try_allocate_on_device(bytes);
  if (data)
    return data;
  std::size_t free = 0, all = 0;
  cudaMemGetInfo(&free, &all);
  throw device_error("not enough device memory: " + std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB asked for " +
                     what_for + ", " + std::to_string(free >> 20) + " MiB free" + on_the_cpu);
}

device::device(const cuda::catalogue &kernels)
    : kernels_(kernels), facts_(under_standard_word(find)), buffers_(std::make_unique<device_buffers>()) {
  const control_word_guard guard; // also for what the driver computes
  device_memory<unsigned> found;
  found.reserve(1, "the self-test");
  check(kernels.self_test(found.data(), nullptr), "starting the self-test");
  unsigned faults = 0;
  check(cudaMemcpy(&faults, found.data(), sizeof faults, cudaMemcpyDeviceToHost), "the self-test");
  for (unsigned bit = 1; bit <= fault_bits; bit <<= 1)
    if (faults & bit)
      throw device_error(
          std::string("the CUDA device ") + facts_.name +
          " does not compute as the error bounds assume: " + text_of(static_cast<arithmetic_fault>(bit)) + on_the_cpu);
  buffers_->create();
  keep_freed_memory();
}

device::~device() {
  buffers_.reset();
  if (pool_) {
    cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &kept_before_);
    cudaMemPoolTrimTo(pool_, kept_before_);
  }
}

cudaStream_t device::stream() const {
  return buffers_->stream;
}

} // namespace meetc
