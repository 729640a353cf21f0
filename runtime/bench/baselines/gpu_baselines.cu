#include "meet/bench/baselines/gpu_baselines.hpp"

#include "meet/bench/baselines/baselines.hpp"

#include <algorithm>

namespace meetc::bench {
namespace {

constexpr unsigned threads = 128;

struct balls_fp32 {
  static constexpr int fields_a = 4, fields_b = 4, rows = 4;
  __device__ static bool hit(const float *a, const float *b) { return baselines::balls(a, b); }
};
struct balls_fp64 {
  static constexpr int fields_a = 4, fields_b = 4, rows = 4;
  __device__ static bool hit(const float *a, const float *b) {
    const double x[4] = {a[0], a[1], a[2], a[3]}, y[4] = {b[0], b[1], b[2], b[3]};
    return baselines::balls(x, y);
  }
};
struct moller_fp32 {
  static constexpr int fields_a = 9, fields_b = 9, rows = 1;
  __device__ static bool hit(const float *a, const float *b) {
    return baselines::moller(a, b, static_cast<float>(baselines::moller_epsilon));
  }
};
struct moller_0_fp32 {
  static constexpr int fields_a = 9, fields_b = 9, rows = 1;
  __device__ static bool hit(const float *a, const float *b) { return baselines::moller(a, b, 0.0F); }
};
struct guigue_devillers_fp32 {
  static constexpr int fields_a = 9, fields_b = 9, rows = 1;
  __device__ static bool hit(const float *a, const float *b) { return baselines::guigue_devillers(a, b); }
};
// The published epsilon of 1e-6 would make every triangle of a fine mesh degenerate.
struct moller_trumbore_0_fp32 {
  static constexpr int fields_a = 6, fields_b = 9, rows = 2;
  __device__ static bool hit(const float *a, const float *b) { return baselines::moller_trumbore(a, b, 0.0F); }
};
struct boxes_fp32 {
  static constexpr int fields_a = 6, fields_b = 6, rows = 4;
  __device__ static bool hit(const float *a, const float *b) { return baselines::boxes(a, b); }
};

// A thread holds some rows of a, and rows of b come through shared memory.
template <class Test>
__global__ void __launch_bounds__(threads)
    count_kernel(const float *a, unsigned n, const float *b, unsigned m, unsigned chunk, unsigned long long *count) {
  __shared__ float tile[threads * Test::fields_b];
  const unsigned first = blockIdx.x * threads * Test::rows + threadIdx.x;
  float mine[Test::rows][Test::fields_a];
#pragma unroll
  for (int r = 0; r < Test::rows; ++r)
#pragma unroll
    for (int f = 0; f < Test::fields_a; ++f)
      mine[r][f] = first + r * threads < n ? a[(first + r * threads) * std::size_t{Test::fields_a} + f] : 0;
  unsigned hits[Test::rows] = {};
  const unsigned begin = blockIdx.y * chunk, end = min(m, begin + chunk);
  for (unsigned at = begin; at < end; at += threads) {
    const unsigned size = min(threads, end - at);
    __syncthreads();
    for (unsigned i = threadIdx.x; i < size * Test::fields_b; i += threads)
      tile[i] = b[at * std::size_t{Test::fields_b} + i];
    __syncthreads();
    if (size == threads) {
#pragma unroll 8
      for (unsigned j = 0; j < threads; ++j)
#pragma unroll
        for (int r = 0; r < Test::rows; ++r)
          hits[r] += Test::hit(mine[r], tile + j * Test::fields_b);
    } else {
      for (unsigned j = 0; j < size; ++j)
#pragma unroll
        for (int r = 0; r < Test::rows; ++r)
          hits[r] += Test::hit(mine[r], tile + j * Test::fields_b);
    }
  }
  unsigned long long all = 0;
#pragma unroll
  for (int r = 0; r < Test::rows; ++r)
    all += first + r * threads < n ? hits[r] : 0;
  for (int d = 16; d > 0; d /= 2)
    all += __shfl_xor_sync(~0U, all, d);
  if (threadIdx.x % 32 == 0 && all > 0)
    atomicAdd(count, all);
}

template <class Test>
cudaError_t launch(const float *a, std::size_t n, const float *b, std::size_t m, unsigned long long *count,
                   cudaStream_t stream) {
  if (n == 0 || m == 0)
    return cudaSuccess;
  const auto blocks = static_cast<unsigned>((n + threads * Test::rows - 1) / (threads * Test::rows));
  const unsigned chunks = blocks > 2048 ? 4 : 8192 / blocks;
  auto chunk = static_cast<unsigned>((m + chunks - 1) / chunks);
  chunk = (chunk + threads - 1) / threads * threads;
  const auto rows = static_cast<unsigned>((m + chunk - 1) / chunk);
  if (rows > 65535)
    return cudaErrorInvalidValue;
  count_kernel<Test><<<dim3(blocks, rows), threads, 0, stream>>>(a, static_cast<unsigned>(n), b,
                                                                 static_cast<unsigned>(m), chunk, count);
  return cudaGetLastError();
}

__device__ unsigned long long now() {
  unsigned long long t;
  asm volatile("mov.u64 %0, %globaltimer;" : "=l"(t));
  return t;
}

__global__ void clock_kernel(clock_reading *out, unsigned long long nanoseconds) {
  const unsigned long long start = now();
  const long long cycle = clock64();
  unsigned long long end = start;
  while (end - start < nanoseconds) {
    __nanosleep(1000);
    end = now();
  }
  out->cycles = static_cast<unsigned long long>(clock64() - cycle);
  out->nanoseconds = now() - start;
}

// Eight reads are under way in each thread, so that the memory is what binds.
constexpr int reads_at_once = 8;

__global__ void __launch_bounds__(threads) read_kernel(const uint4 *from, std::size_t n, unsigned *unused) {
  const std::size_t step = std::size_t{gridDim.x} * threads;
  unsigned all = 0;
  for (std::size_t at = std::size_t{blockIdx.x} * threads + threadIdx.x; at < n; at += step * reads_at_once) {
    uint4 x[reads_at_once];
#pragma unroll
    for (int i = 0; i < reads_at_once; ++i)
      x[i] = at + i * step < n ? from[at + i * step] : uint4{};
#pragma unroll
    for (int i = 0; i < reads_at_once; ++i)
      all += x[i].x + x[i].y + x[i].z + x[i].w;
  }
  if (all == ~0U) // one sum in four billion, which costs nothing and keeps the reads
    *unused = all;
}

template <int Numbers, int Values>
__global__ void __launch_bounds__(256) gather_kernel(gathering g, const unsigned *rows, std::size_t n) {
  const std::size_t step = static_cast<std::size_t>(gridDim.x) * blockDim.x;
  for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < n; i += step) {
    const unsigned a = rows[2 * i], b = rows[2 * i + 1];
    float sum = 0;
#pragma unroll
    for (int k = 0; k < Numbers; ++k)
      sum += g.in[k][k < g.of_first ? a : b];
#pragma unroll
    for (int k = 0; k < Values; ++k)
      g.out[k][i] = sum;
  }
}

} // namespace

template <int Numbers, int Values>
cudaError_t gather_as(const gathering &g, const unsigned *rows, std::size_t n, cudaStream_t stream) {
  gather_kernel<Numbers, Values><<<static_cast<unsigned>((n + 255) / 256), 256, 0, stream>>>(g, rows, n);
  return cudaGetLastError();
}

cudaError_t gather(const gathering &g, const unsigned *rows, std::size_t n, cudaStream_t stream) {
  // The numbers and values of the formulas that are measured.
  if (g.numbers == 8 && g.values == 1)
    return gather_as<8, 1>(g, rows, n, stream);
  if (g.numbers == 8 && g.values == 10)
    return gather_as<8, 10>(g, rows, n, stream);
  if (g.numbers == 10 && g.values == 4)
    return gather_as<10, 4>(g, rows, n, stream);
  if (g.numbers == 14 && g.values == 1)
    return gather_as<14, 1>(g, rows, n, stream);
  return cudaErrorInvalidValue;
}

cudaError_t read_all(const uint4 *from, std::size_t n, unsigned *unused, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  constexpr std::size_t each = std::size_t{threads} * reads_at_once, most_blocks = 4096;
  const auto blocks = static_cast<unsigned>(std::min((n + each - 1) / each, most_blocks));
  read_kernel<<<blocks, threads, 0, stream>>>(from, n, unused);
  return cudaGetLastError();
}

cudaError_t count_pairs(baseline by, const float *a, std::size_t n, const float *b, std::size_t m,
                        unsigned long long *count, cudaStream_t stream) {
  switch (by) {
  case baseline::balls_fp32:
    return launch<balls_fp32>(a, n, b, m, count, stream);
  case baseline::balls_fp64:
    return launch<balls_fp64>(a, n, b, m, count, stream);
  case baseline::moller_fp32:
    return launch<moller_fp32>(a, n, b, m, count, stream);
  case baseline::moller_0_fp32:
    return launch<moller_0_fp32>(a, n, b, m, count, stream);
  case baseline::guigue_devillers_fp32:
    return launch<guigue_devillers_fp32>(a, n, b, m, count, stream);
  case baseline::moller_trumbore_0_fp32:
    return launch<moller_trumbore_0_fp32>(a, n, b, m, count, stream);
  case baseline::boxes_fp32:
    return launch<boxes_fp32>(a, n, b, m, count, stream);
  }
  return cudaErrorInvalidValue;
}

cudaError_t read_clock(clock_reading *out, double milliseconds, cudaStream_t stream) {
  clock_kernel<<<1, 1, 0, stream>>>(out, static_cast<unsigned long long>(milliseconds * 1e6));
  return cudaGetLastError();
}

} // namespace meetc::bench
