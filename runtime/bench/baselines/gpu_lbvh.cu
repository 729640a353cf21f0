#include "meet/bench/baselines/gpu_lbvh.hpp"

#include "meet/bench/baselines/baselines.hpp"
#include "meet/core/device/memory/blocks.hpp"
#include "meet/core/device/set/order_kernels.hpp"

namespace meetc::bench {
namespace {

using baselines::lbvh_box;
using baselines::lbvh_node;

constexpr unsigned query_threads = 128;

template <int Fields>
__global__ void code_kernel(const float *rows, std::uint32_t n, lbvh_box within, std::uint32_t *codes,
                            std::uint32_t *numbers) {
  const std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x;
  if (i < n) {
    codes[i] = baselines::morton_code(baselines::box_of<Fields>(rows + i * Fields), within.lo, within.hi);
    numbers[i] = static_cast<std::uint32_t>(i);
  }
}

// A warp writes 32 rows in one piece.
__global__ void gather_kernel(const float *rows, unsigned fields, const std::uint32_t *order, std::uint32_t n,
                              float *to) {
  const unsigned lane = threadIdx.x % 32;
  for (std::size_t base = blockIdx.x * std::size_t{threads} + threadIdx.x - lane; base < n;
       base += gridDim.x * std::size_t{threads}) {
    const std::uint32_t from = base + lane < n ? order[base + lane] : 0,
                        here = n - base < 32 ? static_cast<std::uint32_t>(n - base) : 32;
    for (unsigned first = 0; first < here * fields; first += 32) {
      const unsigned k = first + lane, row = k / fields;
      const std::uint32_t of = __shfl_sync(~0U, from, row % 32);
      if (k < here * fields)
        to[base * fields + k] = rows[std::size_t{of} * fields + (k - row * fields)];
    }
  }
}

__global__ void link_kernel(const std::uint32_t *codes, std::uint32_t n, lbvh_node *nodes, std::uint32_t *of_nodes,
                            std::uint32_t *of_leaves) {
  const std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x;
  if (i + 1 < n)
    baselines::link(codes, n, static_cast<std::int64_t>(i), nodes, of_nodes, of_leaves);
}

// Whether the other child was there first. The thread that comes second sees all that this one wrote before.
struct arrival {
  std::uint32_t *arrived;
  __device__ bool operator()(std::uint32_t node) const {
    __threadfence();
    const bool second = atomicAdd(arrived + node, 1U) != 0;
    __threadfence();
    return second;
  }
};
// Past the cache of this multiprocessor, which may hold an older value.
struct shared_box {
  __device__ lbvh_box operator()(const lbvh_box &b) const {
    lbvh_box r;
    for (int d = 0; d < 3; ++d)
      r.lo[d] = __ldcg(b.lo + d), r.hi[d] = __ldcg(b.hi + d);
    return r;
  }
};

template <int Fields>
__global__ void fit_kernel(const float *rows, std::uint32_t n, lbvh_node *nodes, const std::uint32_t *of_nodes,
                           const std::uint32_t *of_leaves, std::uint32_t *arrived) {
  const std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x;
  if (i < n)
    baselines::fit(baselines::box_of<Fields>(rows + i * Fields), of_leaves[i], nodes, of_nodes, arrival{arrived},
                   shared_box{});
}

struct balls_fp32 {
  static constexpr int fields_a = 4, fields_b = 4;
  __device__ static baselines::walking_box walking(const float *a) { return {baselines::box_of<4>(a)}; }
  __device__ static bool hit(const float *a, const float *b) { return baselines::balls(a, b); }
};
struct moller_0_fp32 {
  static constexpr int fields_a = 9, fields_b = 9;
  __device__ static baselines::walking_box walking(const float *a) { return {baselines::box_of<9>(a)}; }
  __device__ static bool hit(const float *a, const float *b) { return baselines::moller(a, b, 0.0F); }
};
struct moller_trumbore_0_fp32 {
  static constexpr int fields_a = 6, fields_b = 9;
  __device__ static baselines::walking_segment walking(const float *a) { return baselines::walking_segment(a); }
  __device__ static bool hit(const float *a, const float *b) { return baselines::moller_trumbore(a, b, 0.0F); }
};
struct boxes_fp32 {
  static constexpr int fields_a = 6, fields_b = 6;
  __device__ static baselines::walking_box walking(const float *a) { return {baselines::box_of<6>(a)}; }
  __device__ static bool hit(const float *a, const float *b) { return baselines::boxes(a, b); }
};

template <class Test>
__global__ void __launch_bounds__(query_threads)
    query_kernel(const float *a, std::uint32_t n, const float *b, const std::uint32_t *order, const lbvh_node *nodes,
                 bool itself, index_pair *pairs, unsigned long long capacity, unsigned long long *count) {
  const std::size_t i = blockIdx.x * std::size_t{query_threads} + threadIdx.x;
  if (i >= n)
    return;
  float mine[Test::fields_a];
  for (int f = 0; f < Test::fields_a; ++f)
    mine[f] = a[i * Test::fields_a + f];
  const std::uint32_t number = itself ? order[i] : static_cast<std::uint32_t>(i);
  baselines::walk(nodes, Test::walking(mine), itself ? static_cast<std::int64_t>(i) : -1, [&](std::uint32_t leaf) {
    if (!Test::hit(mine, b + leaf * std::size_t{Test::fields_b}))
      return;
    const unsigned long long at = atomicAdd(count, 1ULL);
    if (at < capacity)
      pairs[at] = {number, order[leaf]};
  });
}

__global__ void __launch_bounds__(query_threads)
    first_kernel(const float *a, std::uint32_t n, const float *b, const std::uint32_t *order, const lbvh_node *nodes,
                 std::uint32_t *first) {
  const std::size_t i = blockIdx.x * std::size_t{query_threads} + threadIdx.x;
  if (i >= n)
    return;
  float mine[6];
  for (int f = 0; f < 6; ++f)
    mine[f] = a[i * 6 + f];
  std::uint32_t found = ~std::uint32_t{0};
  baselines::walk_to_first(nodes, baselines::walking_segment(mine), [&](std::uint32_t leaf, float &most) {
    const float t = baselines::moller_trumbore_position(mine, b + leaf * std::size_t{9}, 0.0F);
    if (t >= 0 && t <= most)
      most = t, found = order[leaf];
  });
  first[i] = found;
}

} // namespace

gpu_lbvh::gpu_lbvh(std::uint32_t elements, unsigned fields) : elements_(elements), fields_(fields) {
  const char *what_for = "a baseline's hierarchy";
  for (auto *m : {&codes_, &sorted_, &numbers_, &order_, &of_nodes_, &of_leaves_, &arrived_})
    m->reserve(elements, what_for);
  rows_.reserve(std::size_t{elements} * fields, what_for);
  nodes_.reserve(elements, what_for);
  check(
      sort_places(nullptr, space_bytes_, nullptr, nullptr, nullptr, nullptr, elements, baselines::morton_bits, nullptr),
      "asking for the sort's memory");
  space_.reserve(space_bytes_, what_for);
}

cudaError_t gpu_lbvh::build(const float *rows, const lbvh_box &within, cudaStream_t stream) {
  if (elements_ < 2)
    return cudaErrorInvalidValue;
  const unsigned blocks = (elements_ + threads - 1) / threads;
  const auto code = fields_ == 4 ? code_kernel<4> : fields_ == 6 ? code_kernel<6> : code_kernel<9>;
  const auto fit = fields_ == 4 ? fit_kernel<4> : fields_ == 6 ? fit_kernel<6> : fit_kernel<9>;
  code<<<blocks, threads, 0, stream>>>(rows, elements_, within, codes_.data(), numbers_.data());
  std::size_t bytes = space_bytes_;
  if (const cudaError_t e = sort_places(space_.data(), bytes, codes_.data(), sorted_.data(), numbers_.data(),
                                        order_.data(), elements_, baselines::morton_bits, stream);
      e != cudaSuccess)
    return e;
  gather_kernel<<<blocks, threads, 0, stream>>>(rows, fields_, order_.data(), elements_, rows_.data());
  link_kernel<<<blocks, threads, 0, stream>>>(sorted_.data(), elements_, nodes_.data(), of_nodes_.data(),
                                              of_leaves_.data());
  if (const cudaError_t e = cudaMemsetAsync(arrived_.data(), 0, elements_ * sizeof(std::uint32_t), stream);
      e != cudaSuccess)
    return e;
  fit<<<blocks, threads, 0, stream>>>(rows_.data(), elements_, nodes_.data(), of_nodes_.data(), of_leaves_.data(),
                                      arrived_.data());
  return cudaGetLastError();
}

cudaError_t gpu_lbvh::query(baseline by, const float *a, std::uint32_t n, index_pair *pairs,
                            unsigned long long capacity, unsigned long long *count, cudaStream_t stream) const {
  return start(by, a, n, false, pairs, capacity, count, stream);
}

cudaError_t gpu_lbvh::query_itself(baseline by, index_pair *pairs, unsigned long long capacity,
                                   unsigned long long *count, cudaStream_t stream) const {
  return start(by, rows_.data(), elements_, true, pairs, capacity, count, stream);
}

cudaError_t gpu_lbvh::start(baseline by, const float *a, std::uint32_t n, bool itself, index_pair *pairs,
                            unsigned long long capacity, unsigned long long *count, cudaStream_t stream) const {
  if (n == 0)
    return cudaSuccess;
  const auto with = [&](auto *kernel) {
    kernel<<<(n + query_threads - 1) / query_threads, query_threads, 0, stream>>>(
        a, n, rows_.data(), order_.data(), nodes_.data(), itself, pairs, capacity, count);
    return cudaGetLastError();
  };
  switch (by) {
  case baseline::balls_fp32:
    return with(query_kernel<balls_fp32>);
  case baseline::moller_0_fp32:
    return with(query_kernel<moller_0_fp32>);
  case baseline::moller_trumbore_0_fp32:
    return with(query_kernel<moller_trumbore_0_fp32>);
  case baseline::boxes_fp32:
    return with(query_kernel<boxes_fp32>);
  default:
    return cudaErrorInvalidValue;
  }
}

cudaError_t gpu_lbvh::first(const float *segments, std::uint32_t n, std::uint32_t *first, cudaStream_t stream) const {
  if (fields_ != 9)
    return cudaErrorInvalidValue;
  if (n > 0)
    first_kernel<<<(n + query_threads - 1) / query_threads, query_threads, 0, stream>>>(
        segments, n, rows_.data(), order_.data(), nodes_.data(), first);
  return cudaGetLastError();
}

} // namespace meetc::bench
