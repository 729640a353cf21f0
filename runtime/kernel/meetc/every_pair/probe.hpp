// The probe: does a matrix unit add as matrix.hpp assumes?
//
// Sixteen million rows by columns of halves, whose exact sums fit in fp64, go through mma.sync and, where the device
// has it, wgmma. A result whose error exceeds 17 2^-23 of the sum of the products' magnitudes refutes the model; the
// filter is then the one in float32. Passing proves nothing: the model stays an assumption. The cases are numbers of
// any exponent; one large addend over small ones at every distance (what is lost in aligning); pairs that cancel except
// for their last bits (what is lost before they cancel); ties; and a large sum that is taken away again in another
// order. Included by nvcc only.
#ifndef MEETC_EVERY_PAIR_PROBE_HPP
#define MEETC_EVERY_PAIR_PROBE_HPP

#include <meetc/every_pair/units.hpp>

namespace meetc::every_pair {

inline constexpr unsigned probe_rounds = 4, probe_blocks = 1024; // which fill a device

__device__ inline unsigned mixed(unsigned x) { // a hash, so that every run has the same cases
  x ^= x >> 16, x *= 0x7feb352dU;
  x ^= x >> 15, x *= 0x846ca68bU;
  return x ^ x >> 16;
}
// The half with value 1.m 2^e and this sign.
__device__ inline std::uint16_t half_of(unsigned negative, int e, unsigned m) {
  return static_cast<std::uint16_t>(negative << 15 | static_cast<unsigned>(e + 15) << 10 | (m & 0x3ff));
}

// Column k of X row or Y column i in a round. Products are multiples of 2^-34 below 2^17, so their sum has at most 53
// bits.
__device__ inline std::uint16_t probe_value(bool first, unsigned round, unsigned i, unsigned k) {
  const unsigned kind = round % 5;
  const auto random = [&](unsigned salt) { return mixed(mixed(mixed(round * 977 + salt) + i * 31) + k * 131 + first); };
  const unsigned r = random(1);
  switch (kind) {
  case 0: // any numbers
    return half_of(r >> 31, static_cast<int>(r >> 20 & 15) % 14 - 7, r);
  case 1: { // one large addend, the others at one distance below it, which Y carries
    const bool large = k == round / 5 % 16;
    const int distance = static_cast<int>(i % 8) + static_cast<int>(round / 80 % 2) * 7;
    return first ? half_of(large ? 0 : r >> 31, large ? 7 : 0, large ? 0 : r)
                 : half_of(0, large ? 7 : -distance, round % 2 ? 0 : r >> 3);
  }
  case 2: { // two and two cancel except for their last bits
    const unsigned twin = mixed(mixed(round * 977 + 5) + i * 31 + k / 2 * 131 + first);
    const unsigned last = k % 2 && !first ? r >> 9 & 1 : 0;
    const int e = static_cast<int>(twin >> 20 & 15) % 14 - 7;
    return half_of(first ? k % 2 : 0, e, twin ^ last);
  }
  case 3: { // powers of two, which make ties when they are added
    const int e = static_cast<int>(r >> 20 & 15) % 14 - 7;
    return half_of(r >> 31, e, 0);
  }
  default: { // a large sum is built up, then taken away again in another order
    const unsigned twin = mixed(mixed(round * 977 + 7) + i * 31 + k % 8 * 131 + first);
    return half_of(first ? k / 8 : 0, static_cast<int>(twin >> 20 & 15) % 10 - 3,
                   twin ^ (k / 8 && !first ? r >> 8 & 1 : 0));
  }
  }
}

// Whether the unit's result for X i and Y j obeys the model.
__device__ inline bool keeps_model(unsigned round, unsigned i, unsigned j, float result) {
  double sum = 0, size = 0;
  for (unsigned k = 0; k < matrix_columns; ++k) {
    const double t = from_half(probe_value(true, round, i, k)) * from_half(probe_value(false, round, j, k));
    sum += t, size += std::fabs(t);
  }
  return std::fabs(static_cast<double>(result) - sum) <= 17 * 0x1p-23 * size;
}
// Columns 2 p and 2 p + 1 of a row.
__device__ inline unsigned probe_pair(bool first, unsigned round, unsigned i, unsigned p) {
  return probe_value(first, round, i, 2 * p) | static_cast<unsigned>(probe_value(first, round, i, 2 * p + 1)) << 16;
}

// A block is one warpgroup: each warp has 16 X, and there are 64 Y.
static __global__ void __launch_bounds__(128) probe_kernel(probe_result *out) {
  __shared__ __align__(128) std::uint16_t y[64 * matrix_columns];
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32, g = lane / 4, t = lane % 4;
  unsigned mma_faults = 0, wgmma_faults = 0, cases = 0;
  for (unsigned r = 0; r < probe_rounds; ++r) {
    const unsigned round = blockIdx.x * probe_rounds + r, row = warp * 16 + g;
    __syncthreads();
    for (unsigned i = threadIdx.x; i < 64 * matrix_columns; i += 128)
      y[matrix_place(i / matrix_columns, static_cast<int>(i % matrix_columns))] =
          probe_value(false, round, i / matrix_columns, i % matrix_columns);
    __syncthreads();
    const unsigned x[4] = {probe_pair(true, round, row, t), probe_pair(true, round, row + 8, t),
                           probe_pair(true, round, row, t + 4), probe_pair(true, round, row + 8, t + 4)};
    const auto *words = reinterpret_cast<const unsigned *>(y);
    for (unsigned s = 0; s < 8; ++s) {
      const mma_results v = multiply(x, uint2{words[s * 64 + g * 4 + t], words[s * 64 + 32 + g * 4 + t]});
      for (unsigned i = 0; i < 4; ++i)
        mma_faults += !keeps_model(round, row + i / 2 * 8, s * 8 + t * 2 + i % 2, __uint_as_float(v.d[i]));
      cases += 4;
    }
#if MEETC_HAS_WGMMA
    asm volatile("fence.proxy.async.shared::cta;" ::: "memory");
    __syncthreads();
    float d[32];
    wgmma_begin();
    multiply(d, x, wgmma_operand(y));
    wgmma_commit();
    wgmma_wait<0>();
    settle(d);
#pragma unroll
    for (unsigned i = 0; i < 32; ++i)
      wgmma_faults += !keeps_model(round, row + i / 2 % 2 * 8, i / 4 * 8 + t * 2 + i % 2, d[i]);
#endif
  }
  atomicAdd(&out->mma_faults, mma_faults);
  atomicAdd(&out->wgmma_faults, wgmma_faults);
  atomicAdd(&out->cases, cases);
  if (MEETC_HAS_WGMMA)
    out->has_wgmma = 1;
}

inline cudaError_t probe(probe_result *out, cudaStream_t stream) {
  cudaError_t e = cudaMemsetAsync(out, 0, sizeof *out, stream);
  if (e == cudaSuccess) {
    probe_kernel<<<probe_blocks, 128, 0, stream>>>(out);
    e = cudaGetLastError();
  }
  return e;
}

} // namespace meetc::every_pair

#endif
