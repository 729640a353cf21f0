// bench/baselines/gpu_baselines.hpp: the baselines of the GPU's kernels: the classic tests on every pair, its clock, and
// reading.
#ifndef MEETC_BENCH_BASELINES_GPU_BASELINES_HPP
#define MEETC_BENCH_BASELINES_GPU_BASELINES_HPP

#include <cstddef>
#include <cuda_runtime_api.h>

namespace meetc::bench {

// Each test as in baselines.hpp, on packed rows in device memory.
enum class baseline {
  balls_fp32,
  balls_fp64,
  moller_fp32,
  moller_0_fp32,
  guigue_devillers_fp32,
  moller_trumbore_0_fp32,
  boxes_fp32
};
constexpr const char *name_of(baseline p) {
  switch (p) {
  case baseline::balls_fp32:
    return "plain Euclidean, fp32";
  case baseline::balls_fp64:
    return "plain Euclidean, fp64";
  case baseline::moller_fp32:
    return "Möller, his epsilon, fp32";
  case baseline::moller_0_fp32:
    return "Möller, epsilon 0, fp32";
  case baseline::guigue_devillers_fp32:
    return "Guigue-Devillers, fp32";
  case baseline::moller_trumbore_0_fp32:
    return "Möller-Trumbore, epsilon 0, fp32";
  case baseline::boxes_fp32:
    return "comparisons, fp32";
  }
  return "";
}

// Tests all n by m pairs and adds the number that the test accepts to *count.
cudaError_t count_pairs(baseline by, const float *a, std::size_t n, const float *b, std::size_t m,
                        unsigned long long *count, cudaStream_t stream);

// Reads n times 16 bytes once, and does no more with them than the compiler needs to be told. `unused` holds one number.
cudaError_t read_all(const uint4 *from, std::size_t n, unsigned *unused, cudaStream_t stream);

// Columns of objects, and columns of values. n values each take the objects rows[2 i] and rows[2 i + 1]: the first `of_first`
// columns of the former, and the others of the latter. Their sum is each of the values.
struct gathering {
  static constexpr int most = 16;
  const float *in[most];
  int numbers, of_first;
  float *out[most];
  int values;
};
cudaError_t gather(const gathering &g, const unsigned *rows, std::size_t n, cudaStream_t stream);

// Cycles of a multiprocessor, and nanoseconds, while one thread waits for about this many milliseconds.
struct clock_reading {
  unsigned long long cycles, nanoseconds;
};
cudaError_t read_clock(clock_reading *out, double milliseconds, cudaStream_t stream);

} // namespace meetc::bench

#endif
