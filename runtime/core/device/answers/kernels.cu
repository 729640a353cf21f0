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

constexpr unsigned few_threads = 1024;
using few_sort = cub::BlockMergeSort<std::uint64_t, few_threads, most_of_few / few_threads>;
__global__ void __launch_bounds__(few_threads) few_kernel(const __grid_constant__ hit_order o) {
  cuda::begin();
  constexpr int each = most_of_few / few_threads;
  constexpr unsigned fewest = 512;
  __shared__ few_sort::TempStorage space;
  const unsigned long long n = *o.count;
  if (n > most_of_few || n > o.capacity) {
    if (threadIdx.x == 0)
      *o.unordered = 1;
    return;
  }
  const auto key = [&](unsigned i) {
    return i < n ? key_of({o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]}, 32) : ~std::uint64_t{0};
  };
  if (n <= fewest) { // the place of each is the number of smaller ones, which some neighbouring threads count together
    __shared__ std::uint64_t all[fewest];
    const unsigned together = n <= few_threads / 8 ? 8 : few_threads / fewest, of = threadIdx.x / together,
                   first = threadIdx.x % together;
    if (threadIdx.x < n)
      all[threadIdx.x] = key(threadIdx.x);
    __syncthreads();
    const std::uint64_t mine = of < n ? all[of] : 0;
    unsigned at = 0;
    for (unsigned i = first; i < n; i += together)
      at += all[i] < mine;
    for (unsigned d = together / 2; d > 0; d /= 2)
      at += __shfl_xor_sync(~0U, at, d);
    if (of < n && first == 0)
      o.sorted[at] = pair_of(mine, 32);
    return;
  }
  std::uint64_t keys[each];
  for (int k = 0; k < each; ++k) {
    const unsigned i = threadIdx.x * each + k;
    keys[k] = key(i);
  }
  few_sort(space).Sort(keys, [](std::uint64_t x, std::uint64_t y) { return x < y; });
  for (int k = 0; k < each; ++k)
    if (const unsigned i = threadIdx.x * each + k; i < n)
      o.sorted[i] = pair_of(keys[k], 32);
}

// No more hits than warps: each compares one with all others.
__device__ void rank_hits(const hit_order &o, unsigned n) {
  for (unsigned i = cuda::grid_thread(); i < n; i += cuda::grid_threads())
    o.by_cell[i] = key_of({o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]}, 32);
  cuda::meet_grid();
  const unsigned lane = threadIdx.x % 32, of = cuda::grid_thread() / 32;
  if (of >= n)
    return;
  const std::uint64_t mine = o.by_cell[of];
  unsigned before = 0;
  for (unsigned k = lane; k < n; k += 32)
    before += o.by_cell[k] < mine;
  before = __reduce_add_sync(~0U, before);
  if (lane == 0)
    o.sorted[before] = pair_of(mine, 32);
}

// Pairs of elements are keys.
__device__ int bits_of(std::uint32_t items) {
  return 32 - __clz(static_cast<int>(items - 1));
}
template <class Keys> __device__ void count_hits(const hit_order &o, Keys &keys) {
  const int bits_b = bits_of(o.items_b);
  constexpr unsigned together = 4;
  keys.template count<together>(
      [&](const std::uint32_t(&i)[together], const bool(&there)[together], std::uint64_t(&key)[together]) {
        index_pair hits[together];
#pragma unroll
        for (unsigned k = 0; k < together; ++k)
          hits[k] = there[k] ? o.hits[i[k]] : index_pair{0, 0};
#pragma unroll
        for (unsigned k = 0; k < together; ++k)
          key[k] = key_of({o.order_a[hits[k].a], o.order_b[hits[k].b]}, bits_b);
      });
}

constexpr unsigned order_threads = 1024;
// The tile of a block that orders some keys, or many.
constexpr unsigned tile_of_some = cuda::most_of_tile, tile_of_many = 2 * cuda::most_of_tile;
template <unsigned Tile> using distributes = cuda::distributing<order_threads, Tile>;
template <unsigned Tile> constexpr std::size_t room_to_distribute = sizeof(typename distributes<Tile>::room);
static_assert(room_to_distribute<tile_of_some> <= cuda::least_shared_memory);
static_assert(most_keys_to_order == cuda::most_cells * cuda::most_near_window);

// The blocks have counted the keys, which become pairs where they were.
template <unsigned Tile>
__device__ void order_counted(distributes<Tile> &keys, const cuda::distribution &d, int bits_b,
                              unsigned long long *unordered) {
  cuda::meet_grid();
  keys.distribute();
  cuda::meet_grid();
  auto *const pairs = reinterpret_cast<index_pair *>(d.keys);
  const bool ordered =
      keys.each_in_order([&](std::uint32_t at, std::uint64_t key) { pairs[at] = pair_of(key, bits_b); });
  if (!ordered && threadIdx.x == 0)
    *unordered = 1;
}

template <unsigned Tile>
__global__ void __launch_bounds__(order_threads, 1) order_keys_kernel(const __grid_constant__ key_order o) {
  const cuda::distribution all_keys{o.keys, o.by_cell, o.n, o.counted};
  distributes<Tile> keys(all_keys, o.bits, false, blockIdx.x, gridDim.x,
                         *reinterpret_cast<typename distributes<Tile>::room *>(cuda::shared_memory()));
  keys.template count_there<4>();
  order_counted<Tile>(keys, all_keys, o.bits_b, o.unordered);
}

template <unsigned Tile>
__global__ void __launch_bounds__(order_threads, 1) order_kernel(const __grid_constant__ hit_order o) {
  const unsigned long long all = *o.count;
  if (all > o.capacity) // not all of them are there
    return;
  const auto n = static_cast<std::uint32_t>(all);
  if (n <= cuda::grid_threads() / 32) {
    rank_hits(o, n);
    return;
  }
  const int bits_b = bits_of(o.items_b);
  const cuda::distribution all_keys{reinterpret_cast<std::uint64_t *>(o.sorted), o.by_cell, n, o.counted};
  distributes<Tile> keys(all_keys, bits_of(o.items_a) + bits_b, false, blockIdx.x, gridDim.x,
                         *reinterpret_cast<typename distributes<Tile>::room *>(cuda::shared_memory()));
  count_hits(o, keys);
  order_counted<Tile>(keys, all_keys, bits_b, o.unordered);
}

// Some devices have no room for a large tile.
bool takes_large_tile(hit_amount amount) {
  return amount == hit_amount::many && room_to_distribute<tile_of_many> <= cuda::shared_memory_of_block();
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

cudaError_t order_hits(const hit_order &o, hit_amount expected, cudaStream_t stream) {
  if (expected == hit_amount::few)
    return cuda::launch<few_kernel>(1, few_threads, stream, o);
  if (takes_large_tile(expected))
    return cuda::launch_together<order_kernel<tile_of_many>, order_threads, room_to_distribute<tile_of_many>>(
        order_threads, stream, o);
  return cuda::launch_together<order_kernel<tile_of_some>, order_threads, room_to_distribute<tile_of_some>>(
      order_threads, stream, o);
}

cudaError_t order_keys(const key_order &o, cudaStream_t stream) {
  if (takes_large_tile(amount_of(o.n)))
    return cuda::launch_together<order_keys_kernel<tile_of_many>, order_threads, room_to_distribute<tile_of_many>>(
        order_threads, stream, o);
  return cuda::launch_together<order_keys_kernel<tile_of_some>, order_threads, room_to_distribute<tile_of_some>>(
      order_threads, stream, o);
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
