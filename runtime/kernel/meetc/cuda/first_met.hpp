// The first hit of each element of a set. Included by nvcc only.
#ifndef MEETC_CUDA_FIRST_MET_HPP
#define MEETC_CUDA_FIRST_MET_HPP

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>
#include <meetc/decide/first_met.hpp>
#include <meetc/decide/take_first.hpp>

namespace meetc::cuda {

inline constexpr int first_met_threads = 128;

// Each lane compares a hit with the first one so far.
template <class Touches, class Order>
__global__ void __launch_bounds__(first_met_threads) first_met_kernel(first_met_job job) {
  begin();
  for (std::size_t i = blockIdx.x * std::size_t{first_met_threads} + threadIdx.x; i < job.count;
       i += gridDim.x * std::size_t{first_met_threads}) {
    const index_pair hit = job.hits[i];
    const float *const row_a = job.a + std::size_t{hit.a} * Touches::inputs_a;
    const auto row_b = [&job](std::uint32_t slot) { return job.b + std::size_t{slot} * Touches::inputs_b; };
    std::uint32_t *const cell = job.first + hit.a;
    const auto before = [&](std::uint32_t slot, std::uint32_t other) {
      return comes_before(::meetc::first_met<Touches, Order>(row_a, row_b(slot), row_b(other)), number_of_b(job, slot),
                          number_of_b(job, other));
    };
    take_first(*static_cast<volatile std::uint32_t *>(cell), hit.b, no_slot, before,
               [cell](std::uint32_t expected, std::uint32_t slot) { return atomicCAS(cell, expected, slot); });
  }
}

template <class Touches, class Order> cudaError_t first_met(const first_met_job &job, cudaStream_t stream) {
  if (job.count == 0)
    return cudaSuccess;
  const std::size_t wanted = (job.count + first_met_threads - 1) / first_met_threads;
  const std::size_t most = blocks_at_once<first_met_kernel<Touches, Order>, first_met_threads>() * std::size_t{4};
  return launch<first_met_kernel<Touches, Order>>(static_cast<unsigned>(wanted < most ? wanted : most),
                                                  first_met_threads, stream, job);
}

} // namespace meetc::cuda

#endif
