// The contact codes of pairs. Included by nvcc only.
//
// All signs are told by floating-point numbers, up to double-double. A pair with a sign that these leave unsure is left to the
// host: integers as long as float32 may need would take the registers of all others.
#ifndef MEETC_CUDA_CONTACTS_HPP
#define MEETC_CUDA_CONTACTS_HPP

#include <meetc/contact/contact.hpp>
#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>

namespace meetc::cuda {

inline constexpr int contact_threads = 128;

template <class Side, int Corners> __global__ void __launch_bounds__(contact_threads) contact_kernel(contact_job job) {
  begin();
  for (std::size_t i = blockIdx.x * std::size_t{contact_threads} + threadIdx.x; i < job.count;
       i += gridDim.x * std::size_t{contact_threads}) {
    const index_pair pair = job.pairs[i];
    contact_signs<bounded_sides<Side>> signs;
    const contact_code code =
        contact_of<Corners>(signs, job.a + std::size_t{3} * Corners * pair.a, job.b + std::size_t{9} * pair.b);
    job.codes[i] = signs.known() ? code.bits() : undecided_code;
  }
}

// For elements of `Corners` corners, and of three. `Side` is the emitted sign of (triangle, point).
template <class Side, int Corners> cudaError_t contacts(const contact_job &job, cudaStream_t stream) {
  if (job.count == 0)
    return cudaSuccess;
  const std::size_t wanted = (job.count + contact_threads - 1) / contact_threads;
  const std::size_t most = blocks_at_once<contact_kernel<Side, Corners>, contact_threads>();
  return launch<contact_kernel<Side, Corners>>(static_cast<unsigned>(wanted < most ? wanted : most), contact_threads,
                                               stream, job);
}

} // namespace meetc::cuda

#endif
