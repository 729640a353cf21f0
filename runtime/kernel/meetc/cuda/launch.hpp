// Kernels that start while the one before them on their stream ends. Included by nvcc, or behind a stand-in for a block.
//
// Most steps of a query are shorter than it takes to start a kernel. So a kernel's blocks may come to the device early, and
// wait there for the memory of the kernel before (CUDA's programmatic dependent launch, capability 9.0).
#ifndef MEETC_CUDA_LAUNCH_HPP
#define MEETC_CUDA_LAUNCH_HPP

#include <cuda_runtime_api.h>

#include <atomic>

namespace meetc::cuda {

// The first statement of a kernel that launch() starts: before it, nothing may be read or written.
__device__ inline void begin() {
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
  asm volatile("griddepcontrol.launch_dependents;");
  asm volatile("griddepcontrol.wait;" ::: "memory");
#endif
}

#if defined(__CUDACC__)
// The dynamic shared memory of a block.
__device__ inline uint4 *shared_memory() {
  extern __shared__ uint4 memory[];
  return memory;
}
#endif

// A number above 0 that is the same for every call on one device; `find` is called once for each, or a few times.
struct number_of_device {
  static constexpr int most = 64;
  std::atomic<unsigned> known[most] = {};

  template <class Find> unsigned get(Find &&find) {
    int which = 0;
    if (cudaGetDevice(&which) != cudaSuccess || which >= most)
      return find();
    unsigned n = known[which].load(std::memory_order_relaxed);
    if (n == 0)
      known[which].store(n = find(), std::memory_order_relaxed);
    return n;
  }
};

// Whether the code that this device runs of a kernel waits in begin().
template <auto Kernel> bool waits() {
  static number_of_device there;
  return there.get([] {
    cudaFuncAttributes of{};
    const bool found = cudaFuncGetAttributes(&of, Kernel) == cudaSuccess;
    return found && of.ptxVersion >= 90 && of.binaryVersion >= 90 ? 2U : 1U;
  }) == 2;
}

// Bytes that one block has at most on every device of compute capability 8.0 or more.
inline constexpr std::size_t least_shared_memory = 101376;

// Lets the blocks of a kernel have so much dynamic shared memory. A request beyond the default is repeated before each launch,
// since a device that is reset forgets it.
inline constexpr std::size_t shared_memory_unasked = 49152;
template <auto Kernel, std::size_t Bytes> void allow_shared_memory() {
  if constexpr (Bytes > shared_memory_unasked)
    if (cudaFuncSetAttribute(Kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(Bytes)) !=
        cudaSuccess)
      cudaGetLastError(); // to start it will fail
}

// As many blocks of this kernel, which need so much dynamic shared memory, as the device runs at once.
template <auto Kernel, unsigned Threads, std::size_t Bytes = 0> unsigned blocks_at_once() {
  static number_of_device there;
  return there.get([] {
    int which = 0, processors = 0, each = 0;
    cudaGetDevice(&which);
    cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, which);
    allow_shared_memory<Kernel, Bytes>();
    cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, Kernel, static_cast<int>(Threads), Bytes);
    return processors > 0 && each > 0 ? static_cast<unsigned>(processors * each) : 1U;
  });
}

// Enqueues a kernel whose first statement is begin().
template <auto Kernel, class... Arguments>
cudaError_t launch(unsigned blocks, unsigned threads, cudaStream_t stream, const Arguments &...arguments) {
  cudaLaunchAttribute early{};
  early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
  early.val.programmaticStreamSerializationAllowed = 1;
  cudaLaunchConfig_t how{};
  how.gridDim = {blocks, 1, 1}, how.blockDim = {threads, 1, 1}, how.stream = stream;
  how.attrs = &early, how.numAttrs = waits<Kernel>() ? 1 : 0;
  return cudaLaunchKernelEx(&how, Kernel, arguments...);
}

// Enqueues a kernel that has no begin().
template <auto Kernel, class... Arguments>
cudaError_t launch_after(unsigned blocks, unsigned threads, cudaStream_t stream, const Arguments &...arguments) {
  cudaLaunchConfig_t how{};
  how.gridDim = {blocks, 1, 1}, how.blockDim = {threads, 1, 1}, how.stream = stream;
  return cudaLaunchKernelEx(&how, Kernel, arguments...);
}

// Enqueues a kernel whose blocks may wait for each other: up to `blocks` of them, as many as the device runs at once and no
// more than a block has threads.
template <auto Kernel, unsigned Threads, std::size_t Bytes = 0, class... Arguments>
cudaError_t launch_together(unsigned blocks, cudaStream_t stream, const Arguments &...arguments) {
  cudaLaunchAttribute together{};
  together.id = cudaLaunchAttributeCooperative;
  together.val.cooperative = 1;
  cudaLaunchConfig_t how{};
  allow_shared_memory<Kernel, Bytes>();
  const unsigned there = blocks_at_once<Kernel, Threads, Bytes>(), most = there < Threads ? there : Threads;
  how.gridDim = {blocks < most ? blocks : most, 1, 1}, how.blockDim = {Threads, 1, 1}, how.stream = stream;
  how.dynamicSmemBytes = Bytes;
  how.attrs = &together, how.numAttrs = 1;
  return cudaLaunchKernelEx(&how, Kernel, arguments...);
}

} // namespace meetc::cuda

#endif
