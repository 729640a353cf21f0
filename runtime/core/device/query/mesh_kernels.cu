#include "meet/core/device/query/mesh_kernels.hpp"

#include "meet/core/device/memory/blocks.hpp"
#include "meet/core/query/common_corners.hpp"
#include "meet/core/views/collinear.hpp"

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/lists.hpp>

namespace meetc::on_device {
namespace {

// ---- the corners ----

__device__ bool one_point(const float *x, const float *y) {
  return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}
__device__ std::uint32_t hash_of(const float *x) {
  std::uint32_t h = 0;
  for (int k = 0; k < 3; ++k) {
    h = (h ^ __float_as_uint(x[k] == 0 ? 0.0F : x[k])) * 0x9e3779b1U;
    h ^= h >> 15;
  }
  return h * 0x85ebca6bU;
}

// Each corner takes a free cell after its hash, or the number of the corner there that lies in its point.
__global__ void number_kernel(const float *rows, std::size_t corners, std::uint32_t *cells, int bits,
                              std::uint32_t *numbers) {
  cuda::begin();
  const std::uint32_t last = ~std::uint32_t{0} >> (32 - bits);
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < corners;
       i += gridDim.x * std::size_t{threads}) {
    const auto mine = static_cast<std::uint32_t>(i);
    const float *const point = rows + 3 * i;
    std::uint32_t at = hash_of(point) >> (32 - bits), other = mine;
    for (;; at = (at + 1) & last) {
      other = *static_cast<volatile std::uint32_t *>(cells + at);
      if (other == cuda::no_slot)
        other = atomicCAS(cells + at, cuda::no_slot, mine);
      if (other == cuda::no_slot)
        other = mine;
      if (other == mine || one_point(rows + std::size_t{3} * other, point))
        break;
    }
    numbers[i] = other;
  }
}

__global__ void name_kernel(const std::uint32_t *vertices, const std::uint32_t *order, std::size_t corners,
                            std::uint32_t *numbers) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < corners;
       i += gridDim.x * std::size_t{threads})
    numbers[i] = vertices ? vertices[std::size_t{3} * order[i / 3] + i % 3] : static_cast<std::uint32_t>(i);
}

__global__ void order_kernel(const float *rows, std::size_t floats, float *to) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < floats;
       i += gridDim.x * std::size_t{threads}) {
    const std::size_t row = i / 9;
    const auto at = static_cast<unsigned>(i - 9 * row), order = static_cast<unsigned>(row % orders_of_corners);
    const int corner = corner_in_order(static_cast<int>(order), static_cast<int>(at / 3));
    to[i] = rows[9 * (row / orders_of_corners) + static_cast<unsigned>(3 * corner) + at % 3];
  }
}

// ---- elements without an extent ----

__global__ void flat_kernel(const float *rows, const std::uint32_t *order, std::size_t n, flat_element *found,
                            unsigned *count) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    const float *const row = rows + 9 * i;
    if (!may_be_collinear(row))
      continue;
    flat_element &to = found[atomicAdd(count, 1U)];
    to.element = order[i];
    for (int k = 0; k < 9; ++k)
      to.row[k] = row[k];
  }
}

// ---- the candidates ----

// The number of common corners, or -1 for a pair that is left out. Makes of the pair what its list holds.
__device__ int sort_pair(const sorting_job &job, index_pair &pair) {
  if (pair.a == pair.b)
    return -1;
  std::uint32_t of_a = job.order[pair.a], of_b = job.order[pair.b];
  if (of_a > of_b) {
    const std::uint32_t slot = pair.a, element = of_a;
    pair.a = pair.b, pair.b = slot;
    of_a = of_b, of_b = element;
  }
  if (job.owner && job.owner[of_a] == job.owner[of_b])
    return -1;
  const std::uint32_t *const mine = job.numbers + std::size_t{3} * pair.a, *const theirs =
                                                                               job.numbers + std::size_t{3} * pair.b;
  unsigned bits = common_bits(mine, theirs);
  if (bits == 0)
    return 0;
  bits &= bits_of_first(mine);
  const common_order o = order_by(bits);
  pair.a = orders_of_corners * pair.a + static_cast<unsigned>(order_with(o.mine[0], o.mine[1]));
  pair.b = orders_of_corners * pair.b + static_cast<unsigned>(order_with(o.theirs[0], o.theirs[1]));
  return o.common;
}

__global__ void __launch_bounds__(cuda::step_threads) sorting_kernel(const __grid_constant__ sorting_job job) {
  cuda::begin();
  constexpr unsigned room = cuda::waiting_pairs / 2;
  __shared__ index_pair rooms[cuda::step_warps][3][room];
  index_pair(&mine)[3][room] = rooms[threadIdx.x / 32];
  cuda::waiting_list<room> apart(job.apart, mine[0]), one(job.one, mine[1]), two(job.two, mine[2]);
  for (cuda::list_share w(job.candidates); w.at < w.n; w.at += w.stride) {
    index_pair p[cuda::step_pairs] = {};
    unsigned in_apart = 0, in_one = 0, in_two = 0, in_three = 0;
#pragma unroll
    for (int k = 0; k < cuda::step_pairs; ++k)
      if (w.index(k) < w.n)
        p[k] = job.candidates.pairs[w.index(k)];
#pragma unroll
    for (int k = 0; k < cuda::step_pairs; ++k)
      if (w.index(k) < w.n) {
        const int common = sort_pair(job, p[k]);
        in_apart |= static_cast<unsigned>(common == 0) << k;
        in_one |= static_cast<unsigned>(common == 1) << k;
        in_two |= static_cast<unsigned>(common == 2) << k;
        in_three |= static_cast<unsigned>(common == 3) << k;
      }
    apart.append(in_apart, p);
    one.append(in_one, p);
    two.append(in_two, p);
    cuda::append(in_three, p, job.three);
    if (in_three != 0)
      atomicAdd(job.three_count, static_cast<unsigned long long>(__popc(in_three)));
  }
  apart.flush_block<cuda::step_warps>();
  one.flush_block<cuda::step_warps>();
  two.flush_block<cuda::step_warps>();
}

__global__ void slots_kernel(cuda::pair_list rows) {
  cuda::begin();
  const unsigned long long all = *rows.count, n = all < rows.capacity ? all : rows.capacity;
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    rows.pairs[i] = {rows.pairs[i].a / orders_of_corners, rows.pairs[i].b / orders_of_corners};
}

} // namespace

cudaError_t number_corners(const float *rows, std::uint32_t n, std::uint32_t *cells, int bits, std::uint32_t *numbers,
                           cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const std::size_t corners = std::size_t{3} * n;
  const cudaError_t cleared = cudaMemsetAsync(cells, 0xff, sizeof *cells << bits, stream); // all no_slot
  return cleared != cudaSuccess
             ? cleared
             : cuda::launch<number_kernel>(blocks_for(corners), threads, stream, rows, corners, cells, bits, numbers);
}

cudaError_t name_corners(const std::uint32_t *vertices, const std::uint32_t *order, std::uint32_t n,
                         std::uint32_t *numbers, cudaStream_t stream) {
  const std::size_t corners = std::size_t{3} * n;
  return n == 0 ? cudaSuccess
                : cuda::launch<name_kernel>(blocks_for(corners), threads, stream, vertices, order, corners, numbers);
}

cudaError_t order_corners(const float *rows, std::uint32_t n, float *to, cudaStream_t stream) {
  const std::size_t floats = std::size_t{9} * orders_of_corners * n;
  return n == 0 ? cudaSuccess : cuda::launch<order_kernel>(blocks_for(floats), threads, stream, rows, floats, to);
}

cudaError_t find_flat(const float *rows, const std::uint32_t *order, std::uint32_t n, flat_element *found,
                      unsigned *count, cudaStream_t stream) {
  return n == 0 ? cudaSuccess
                : cuda::launch<flat_kernel>(blocks_for(n), threads, stream, rows, order, std::size_t{n}, found, count);
}

cudaError_t sort_by_corners(const sorting_job &job, cudaStream_t stream) {
  return cuda::launch_step<sorting_kernel>(stream, job);
}

cudaError_t to_slots(const cuda::pair_list &rows, cudaStream_t stream) {
  return cuda::launch<slots_kernel>(cuda::blocks_at_once<slots_kernel, threads>(), threads, stream, rows);
}

} // namespace meetc::on_device
