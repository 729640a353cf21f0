#include "meet/core/device/memory/device.hpp"

#include "meet/core/device/memory/buffers.hpp"
#include "meetc/number/self_test.hpp"

#include <atomic>

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
    throw missing_device(why);
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

// The error of the last free that failed.
static std::atomic<cudaError_t> failed_free{cudaSuccess};

void check(cudaError_t e, const char *what) {
  if (e == cudaSuccess && failed_free.load(std::memory_order_relaxed) == cudaSuccess)
    return;
  cudaGetLastError(); // clears an error that can be cleared
  const cudaError_t freed = failed_free.exchange(cudaSuccess);
  if (e == cudaSuccess)
    e = freed, what = "freeing memory";
  if (e == cudaSuccess)
    return;
  const std::string told = std::string("CUDA: ") + what + ": " + cudaGetErrorString(e) + on_the_cpu;
  if (e == cudaErrorMemoryAllocation)
    throw device_memory_error(told);
  throw device_error(told);
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

void free_on_device(void *data) noexcept {
  if (!data)
    return;
  const control_word_guard guard;
  int now = 0;
  cudaPointerAttributes of{};
  const auto done = [](cudaError_t e) {
    if (e != cudaSuccess && e != cudaErrorCudartUnloading) // which is no error at the process's end
      failed_free = e;
    return e == cudaSuccess;
  };
  if (!done(cudaGetDevice(&now)) || !done(cudaPointerGetAttributes(&of, data)) || !done(cudaSetDevice(of.device)))
    return;
  done(cudaDeviceSynchronize()); // memory of the pool may be in use
  done(cudaFree(data));
  done(cudaSetDevice(now));
}

void *allocate_on_device(std::size_t bytes, const char *what_for) {
  void *const data = try_allocate_on_device(bytes);
  if (data)
    return data;
  std::size_t free = 0, all = 0;
  cudaMemGetInfo(&free, &all);
  throw device_memory_error("not enough device memory: " + std::to_string((bytes + (1 << 20) - 1) >> 20) +
                            " MiB asked for " + what_for + ", " + std::to_string(free >> 20) + " MiB free" +
                            on_the_cpu);
}

// The process's pool keeps what is freed: a query allocates for each set that it sees, and the driver takes long for that.
class kept_memory {
public:
  kept_memory() = default;
  kept_memory(const kept_memory &) = delete;
  kept_memory &operator=(const kept_memory &) = delete;

  void keep() {
    int number = 0;
    std::uint64_t all = ~std::uint64_t{0};
    if (cudaGetDevice(&number) == cudaSuccess && cudaDeviceGetDefaultMemPool(&pool_, number) == cudaSuccess &&
        cudaMemPoolGetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &before_) == cudaSuccess &&
        cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &all) == cudaSuccess)
      return;
    cudaGetLastError(); // there are devices without a pool
    pool_ = nullptr;
  }
  ~kept_memory() {
    if (!pool_)
      return;
    cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &before_);
    cudaMemPoolTrimTo(pool_, before_);
  }

private:
  cudaMemPool_t pool_ = nullptr; // null: there is none
  std::uint64_t before_ = 0;     // what the pool kept of freed memory, in bytes
};

struct device::state {
  const cuda::catalogue &kernels;
  device_facts facts;
  std::recursive_mutex in_use;
  kept_memory pool;
  device_buffers buffers; // which go before the pool does

  explicit state(const cuda::catalogue &of) : kernels(of), facts(under_standard_word(find)) {}
};

device::device(const cuda::catalogue &kernels) : state_(std::make_shared<state>(kernels)) {
  const control_word_guard guard; // also for what the driver computes
  device_memory<unsigned> found;
  found.reserve(1, "the self-test");
  check(kernels.self_test(found.data(), nullptr), "starting the self-test");
  unsigned faults = 0;
  check(cudaMemcpy(&faults, found.data(), sizeof faults, cudaMemcpyDeviceToHost), "the self-test");
  for (unsigned bit = 1; bit <= fault_bits; bit <<= 1)
    if (faults & bit)
      throw missing_device(
          std::string("the CUDA device ") + facts().name +
          " does not compute as the error bounds assume: " + text_of(static_cast<arithmetic_fault>(bit)) + on_the_cpu);
  state_->buffers.create();
  state_->pool.keep();
}

const cuda::catalogue &device::kernels() const {
  return state_->kernels;
}
const device_facts &device::facts() const {
  return state_->facts;
}
cudaStream_t device::stream() const {
  return state_->buffers.stream;
}
device_buffers &device::buffers() const {
  return state_->buffers;
}
std::unique_lock<std::recursive_mutex> device::use() const {
  return std::unique_lock(state_->in_use);
}

} // namespace meetc
