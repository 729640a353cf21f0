#include "meet/core/device/answers/kernels.hpp"

#include "meet/core/device/memory/blocks.hpp"

#include <cub/cub.cuh>
#include <meetc/cuda/distribute.hpp>
#include <meetc/cuda/grid.hpp>
#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>

namespace meetc::on_device {
namespace {

__global__ void keys_kernel(const index_pair *slots, std::size_t n, const std::uint32_t *order_a,
                            const std::uint32_t *owner_a, const std::uint32_t *order_b, const std::uint32_t *owner_b,
                            int bits_b, std::uint64_t *keys) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    std::uint32_t a = order_a[slots[i].a], b = order_b[slots[i].b];
    a = owner_a ? owner_a[a] : a;
    b = owner_b ? owner_b[b] : b;
    keys[i] = key_of({a, b}, bits_b);
  }
}

__global__ void pairs_kernel(std::uint64_t *keys, std::size_t n, int bits_b) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    reinterpret_cast<index_pair *>(keys)[i] = pair_of(keys[i], bits_b);
}

// Pairs of elements are keys. To sort them by digits takes a kernel for each digit and four more, which the host starts once it
// has read the number of hits. This kernel saves these and the wait.
constexpr unsigned order_threads = 1024;
using distributes = cuda::distributing<order_threads>;
constexpr std::size_t room_to_distribute = sizeof(distributes::room);
static_assert(room_to_distribute <= cuda::least_shared_memory);

__device__ int bits_of(std::uint32_t items) {
  return 32 - __clz(static_cast<int>(items - 1));
}

__global__ void __launch_bounds__(order_threads, 1) order_kernel(const __grid_constant__ hit_order o) {
  const unsigned long long all = *o.count;
  if (all == 0 || all > o.capacity) // none, or not all of them are there
    return;
  const auto n = static_cast<std::uint32_t>(all);
  // The hits of one window are the work of one block, which has no others to meet.
  const unsigned blocks = n <= cuda::most_of_window ? 1 : gridDim.x;
  if (blockIdx.x >= blocks)
    return;
  const auto meet = [blocks] {
    if (blocks > 1)
      cuda::meet_grid();
  };
  const int bits_b = bits_of(o.items_b);
  const cuda::distribution all_keys{reinterpret_cast<std::uint64_t *>(o.sorted), o.by_cell, n, o.counted};
  distributes keys(all_keys, bits_of(o.items_a) + bits_b, false, blockIdx.x, blocks,
                   *reinterpret_cast<distributes::room *>(cuda::shared_memory()));
  constexpr unsigned together = 4;
  keys.count<together>(
      [&](const std::uint32_t(&i)[together], const bool(&there)[together], std::uint64_t(&key)[together]) {
        index_pair hits[together];
#pragma unroll
        for (unsigned k = 0; k < together; ++k)
          hits[k] = there[k] ? o.hits[i[k]] : index_pair{0, 0};
#pragma unroll
        for (unsigned k = 0; k < together; ++k)
          key[k] = key_of({o.order_a[hits[k].a], o.order_b[hits[k].b]}, bits_b);
      });
  meet();
  keys.distribute();
  meet();
  keys.clear();
  const bool ordered =
      keys.each_in_order([&](std::uint32_t at, std::uint64_t key) { o.sorted[at] = pair_of(key, bits_b); });
  if (!ordered && threadIdx.x == 0)
    *o.unordered = 1;
}

// Adds 1 to the counter `at` of each lane that is there, once for all with the same one. The whole warp calls it.
__device__ void count_each(unsigned long long *counters, bool there, std::uint32_t at) {
  const unsigned lanes = __ballot_sync(~0U, there);
  if (!there)
    return;
  const unsigned alike = __match_any_sync(lanes, at);
  if (threadIdx.x % 32 == __ffs(alike) - 1)
    atomicAdd(counters + at, static_cast<unsigned long long>(__popc(alike)));
}
__global__ void tally_kernel(hit_tally t) {
  cuda::begin();
  const unsigned lane = threadIdx.x % 32;
  for (std::size_t first = blockIdx.x * std::size_t{threads} + threadIdx.x - lane; first < t.n;
       first += gridDim.x * std::size_t{threads}) { // a warp stays whole
    const bool there = first + lane < t.n;
    const index_pair hit = there ? t.hits[first + lane] : t.hits[first];
    if (t.counts_a)
      count_each(t.counts_a, there, t.order_a[hit.a]);
    if (t.counts_b)
      count_each(t.counts_b, there, t.of_instance > 0 ? hit.b / t.of_instance : t.order_b[hit.b]);
    if (t.flags_a)
      t.flags_a[t.order_a[hit.a]] = 1, t.flags_b[t.order_b[hit.b]] = 1;
  }
}

__global__ void name_kernel(const std::uint32_t *slots, std::uint32_t n, const std::uint32_t *order_a,
                            const std::uint32_t *order_b, std::uint32_t *named) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    named[order_a[i]] = slots[i] == cuda::no_slot ? cuda::no_slot : order_b[slots[i]];
}

__global__ void renumber_kernel(index_pair *pairs, std::size_t n, index_pair by) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    pairs[i].a += by.a, pairs[i].b += by.b;
}

} // namespace

cudaError_t renumber(index_pair *pairs, std::size_t n, index_pair by, cudaStream_t stream) {
  return n == 0 || (by.a == 0 && by.b == 0)
             ? cudaSuccess
             : cuda::launch<renumber_kernel>(blocks_for(n), threads, stream, pairs, n, by);
}

cudaError_t name_slots(const std::uint32_t *slots, std::uint32_t n, const std::uint32_t *order_a,
                       const std::uint32_t *order_b, std::uint32_t *named, cudaStream_t stream) {
  return n == 0 ? cudaSuccess
                : cuda::launch<name_kernel>(blocks_for(n), threads, stream, slots, n, order_a, order_b, named);
}

cudaError_t tally(const hit_tally &t, cudaStream_t stream) {
  if (t.n == 0)
    return cudaSuccess;
  return cuda::launch<tally_kernel>(blocks_for(t.n), threads, stream, t);
}

cudaError_t order_hits(const hit_order &o, cudaStream_t stream) {
  return cuda::launch_together<order_kernel, order_threads, room_to_distribute>(order_threads, stream, o);
}

cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, int bits_b, std::uint64_t *keys,
                    cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  return cuda::launch<keys_kernel>(blocks_for(n), threads, stream, slots, n, order_a, owner_a, order_b, owner_b, bits_b,
                                   keys);
}

cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, int bits_b, cudaStream_t stream) {
  static_assert(sizeof(index_pair) == sizeof(std::uint64_t));
  if (n == 0)
    return cudaSuccess;
  return cuda::launch<pairs_kernel>(blocks_for(n), threads, stream, keys, n, bits_b);
}

cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream) {
  return cub::DeviceRadixSort::SortKeys(space, bytes, keys, to, n, 0, bits, stream);
}

cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream) {
  return cub::DeviceSelect::Unique(space, bytes, keys, to, kept, static_cast<std::int64_t>(n), stream);
}

} // namespace meetc::on_device
