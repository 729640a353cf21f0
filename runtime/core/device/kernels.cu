#include "core/device/kernels.hpp"

#include "core/device/blocks.hpp"

#include <cub/cub.cuh>
#include <meetc/cuda_grid.hpp>
#include <meetc/cuda_launch.hpp>
#include <meetc/cuda_table.hpp>

#include <algorithm>

namespace meetc {
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

// The place of a key among those of its item is the number of smaller ones. Most items have one.
__global__ void runs_kernel(const std::uint64_t *keys, std::size_t n, int bits_b, index_pair *to,
                            unsigned long long *crowded) {
  cuda::begin();
  const std::uint64_t of_item = ~std::uint64_t{0} << bits_b; // the bits of a key that name its item
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    const std::uint64_t key = keys[i];
    const auto alike = [&](std::size_t k) { return ((keys[k] ^ key) & of_item) == 0; };
    const bool follows = i > 0 && alike(i - 1), leads = i + 1 < n && alike(i + 1);
    unsigned before = 0, length = 1; // of the keys of the item, the smaller ones, and all
    if (follows)
      for (std::size_t k = i; k > 0 && length <= most_in_run && alike(k - 1); --k, ++length)
        before += keys[k - 1] < key;
    const std::size_t begin = i + 1 - length;
    if (leads)
      for (std::size_t k = i + 1; k < n && length <= most_in_run && alike(k); ++k, ++length)
        before += keys[k] < key;
    if (length > most_in_run)
      *crowded = length;
    else
      to[begin + before] = pair_of(key, bits_b);
  }
}

__global__ void reaches_kernel(const float *rows, std::size_t numbers, unsigned fields, std::uint64_t lengths,
                               unsigned *most) {
  unsigned of[2] = {0, 0}; // magnitudes, whose order is that of their bits
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < numbers;
       i += gridDim.x * std::size_t{threads}) {
    const unsigned bits = __float_as_uint(rows[i]) & 0x7fffffff;
    const auto field = static_cast<unsigned>(i % fields);
    const bool length = field < 64 && (lengths >> field & 1) != 0;
    of[length] = bits > of[length] ? bits : of[length];
  }
  for (int k = 0; k < 2; ++k) {
    unsigned warp = of[k];
    for (int d = 16; d > 0; d /= 2)
      warp = max(warp, __shfl_xor_sync(~0U, warp, d));
    if (threadIdx.x % 32 == 0)
      atomicMax(most + k, warp);
  }
}

// What a thread does for each hit.
template <class Each> __device__ void each_hit(const hit_order &o, Each &&each) {
  const unsigned long long n = *o.count < o.capacity ? *o.count : o.capacity;
  for (unsigned long long i = cuda::grid_thread(); i < n; i += cuda::grid_threads())
    each(i, o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]);
}
// The place of a hit among those of its item is the number of smaller ones. A lane takes an item with few hits, eight lanes one
// with more, and the warp one with many.
__device__ void place_each(const hit_order &o, std::size_t item, std::uint32_t begin, std::uint32_t end, unsigned first,
                           unsigned step) {
  for (std::uint32_t i = begin + first; i < end; i += step) {
    const std::uint32_t b = o.others[i];
    std::uint32_t at = begin;
    for (std::uint32_t k = begin; k < end; ++k)
      at += o.others[k] < b;
    o.sorted[at] = {static_cast<std::uint32_t>(item), b};
  }
}
// The same of up to 32 hits of an item, by eight lanes of which each keeps four; a lane of another eight has another item.
__device__ void place_by_eight(const hit_order &o, std::size_t item, std::uint32_t begin, std::uint32_t hits) {
  constexpr unsigned each = 4, eight = 8;
  constexpr std::uint32_t none = ~std::uint32_t{0}; // above any element's number
  const unsigned lane = threadIdx.x % 32, within = lane % eight;
  std::uint32_t mine[each], before[each] = {0, 0, 0, 0};
#pragma unroll
  for (unsigned k = 0; k < each; ++k)
    mine[k] = within + k * eight < hits ? o.others[begin + within + k * eight] : none;
#pragma unroll
  for (unsigned k = 0; k < each; ++k)
    if (__any_sync(~0U, k * eight < hits))
#pragma unroll
      for (unsigned l = 0; l < eight; ++l) {
        const std::uint32_t other = __shfl_sync(~0U, mine[k], lane - within + l);
#pragma unroll
        for (unsigned m = 0; m < each; ++m)
          before[m] += other < mine[m];
      }
#pragma unroll
  for (unsigned k = 0; k < each; ++k)
    if (within + k * eight < hits)
      o.sorted[begin + before[k]] = {static_cast<std::uint32_t>(item), mine[k]};
}
__device__ void place_hits(const hit_order &o) {
  constexpr std::uint32_t few = 4, many = 32;
  constexpr unsigned together = 8;
  const unsigned lane = threadIdx.x % 32;
  for (std::size_t first = cuda::grid_thread() - lane; first < o.items_a; first += cuda::grid_threads()) {
    const std::size_t item = first + lane;
    const bool there = item < o.items_a;
    const std::uint32_t begin = there ? o.starts[item] : 0, end = there ? o.starts[item + 1] : 0;
    const bool crowded = end - begin > most_of_one;
    if (crowded)
      atomicMax(o.longest, static_cast<unsigned long long>(end - begin));
    else if (end - begin <= few)
      place_each(o, item, begin, end, 0, 1);
    const unsigned more = __ballot_sync(~0U, end - begin > few && end - begin <= many);
    for (unsigned round = 0; round < together && more >> round * (32 / together) != 0; ++round) {
      const unsigned of = round * (32 / together) + lane / together;
      const std::uint32_t from = __shfl_sync(~0U, begin, of), to = __shfl_sync(~0U, end, of);
      place_by_eight(o, first + of, from, more >> of & 1 ? to - from : 0);
    }
    for (unsigned left = __ballot_sync(~0U, !crowded && end - begin > many); left; left &= left - 1) {
      const unsigned of = __ffs(left) - 1;
      place_each(o, first + of, __shfl_sync(~0U, begin, of), __shfl_sync(~0U, end, of), lane, 32);
    }
  }
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
      *o.longest = n;
    return;
  }
  const auto key = [&](unsigned i) {
    return i < n ? key_of({o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]}, 32) : ~std::uint64_t{0};
  };
  if (n <= fewest) { // the place of each is the number of smaller ones
    __shared__ std::uint64_t all[fewest];
    const std::uint64_t mine = key(threadIdx.x);
    if (threadIdx.x < fewest)
      all[threadIdx.x] = mine;
    __syncthreads();
    unsigned at = 0;
    for (unsigned i = 0; i < n; ++i)
      at += all[i] < mine;
    if (threadIdx.x < n)
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
  auto *const keys = reinterpret_cast<std::uint64_t *>(o.ranks); // whose room is followed by that of o.others
  for (unsigned i = cuda::grid_thread(); i < n; i += cuda::grid_threads())
    keys[i] = key_of({o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]}, 32);
  cuda::meet_grid();
  const unsigned lane = threadIdx.x % 32, of = cuda::grid_thread() / 32;
  if (of >= n)
    return;
  const std::uint64_t mine = keys[of];
  unsigned before = 0;
  for (unsigned k = lane; k < n; k += 32)
    before += keys[k] < mine;
  before = __reduce_add_sync(~0U, before);
  if (lane == 0)
    o.sorted[before] = pair_of(mine, 32);
}

// Hits are counted by their items, sums of the counts say where those of each item begin, and there they are put into order.
constexpr unsigned order_threads = 1024;
static_assert(order_threads <= most_order_blocks);
__global__ void __launch_bounds__(order_threads, 2) order_kernel(const __grid_constant__ hit_order o) {
  if (const unsigned long long n = *o.count; n <= cuda::grid_threads() / 32 && n <= o.capacity) {
    rank_hits(o, static_cast<unsigned>(n));
    return;
  }
  __shared__ unsigned room[order_threads / 32];
  each_hit(o, [&](unsigned long long i, std::uint32_t a, std::uint32_t) { o.ranks[i] = atomicAdd(o.starts + a, 1); });
  cuda::meet_grid();
  cuda::running_sums{o.starts, o.items_a + 1, o.totals, blockIdx.x, gridDim.x}.sum<order_threads>(room);
  cuda::meet_grid();
  each_hit(o, [&](unsigned long long i, std::uint32_t a, std::uint32_t b) { o.others[o.starts[a] + o.ranks[i]] = b; });
  cuda::meet_grid();
  place_hits(o);
}

// Adds 1 to the counter `at`, once for all lanes with the same one.
__device__ void count_one(unsigned long long *counters, std::uint32_t at) {
  const unsigned alike = __match_any_sync(__activemask(), at);
  if (threadIdx.x % 32 == __ffs(alike) - 1)
    atomicAdd(counters + at, static_cast<unsigned long long>(__popc(alike)));
}
__global__ void tally_kernel(hit_tally t) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < t.n;
       i += gridDim.x * std::size_t{threads}) {
    const index_pair hit = t.hits[i];
    if (t.counts_a)
      count_one(t.counts_a, t.order_a[hit.a]);
    if (t.counts_b)
      count_one(t.counts_b, t.of_instance > 0 ? hit.b / t.of_instance : t.order_b[hit.b]);
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

__global__ void renumber_kernel(index_pair *pairs, std::size_t n, std::uint32_t by) {
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    pairs[i].a += by;
}

} // namespace

cudaError_t renumber(index_pair *pairs, std::size_t n, std::uint32_t by, cudaStream_t stream) {
  return n == 0 || by == 0 ? cudaSuccess : cuda::launch<renumber_kernel>(blocks_for(n), threads, stream, pairs, n, by);
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
  // Few blocks meet sooner; many items mostly have many hits.
  const unsigned blocks = std::max(128U, o.items_a / order_threads);
  return cuda::launch_together<order_kernel, order_threads>(blocks, stream, o);
}

cudaError_t order_few_hits(const hit_order &o, cudaStream_t stream) {
  return cuda::launch<few_kernel>(1, few_threads, stream, o);
}

cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(most, 0, 2 * sizeof(float), stream);
  if (e != cudaSuccess || n == 0)
    return e;
  reaches_kernel<<<blocks_for(n * fields), threads, 0, stream>>>(rows, n * fields, fields, lengths,
                                                                 reinterpret_cast<unsigned *>(most));
  return cudaGetLastError();
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
                      int first_bit, int bits, cudaStream_t stream) {
  return cub::DeviceRadixSort::SortKeys(space, bytes, keys, to, n, first_bit, bits, stream);
}

cudaError_t order_runs(const std::uint64_t *keys, std::size_t n, int bits_b, index_pair *to,
                       unsigned long long *crowded, cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(crowded, 0, sizeof *crowded, stream);
  if (e != cudaSuccess || n == 0)
    return e;
  return cuda::launch<runs_kernel>(blocks_for(n), threads, stream, keys, n, bits_b, to, crowded);
}

cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream) {
  return cub::DeviceSelect::Unique(space, bytes, keys, to, kept, static_cast<std::int64_t>(n), stream);
}

} // namespace meetc
