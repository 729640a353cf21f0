// Lists of pairs: whole warps read their shares of one and append to others. Only the device knows how long a list is, so that
// kernels are launched for the whole device and walk it in strides. Included by nvcc only.
#ifndef MEETC_CUDA_LISTS_HPP
#define MEETC_CUDA_LISTS_HPP

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>

namespace meetc::cuda {

// ---- to read one ----

inline constexpr int step_threads = 128, step_warps = step_threads / 32;
// Enqueues a step for the whole device.
template <auto Kernel, class... Arguments> cudaError_t launch_step(cudaStream_t stream, const Arguments &...arguments) {
  return launch<Kernel>(blocks_at_once<Kernel, step_threads>(), step_threads, stream, arguments...);
}

// The number of pairs that a lane takes at once from a long list: their rows are loaded together, and counters are
// updated less often. From a short list a lane takes one pair, so that all lanes have work.
inline constexpr int step_pairs = 4;

// The share of a list that a warp takes at a time, and where it begins.
struct list_share {
  unsigned long long n, at, stride;
  unsigned each; // pairs for a lane
  __device__ explicit list_share(const pair_list &l) : n(l.count && *l.count < l.capacity ? *l.count : l.capacity) {
    const unsigned long long lanes = gridDim.x * std::size_t{step_threads};
    each = n >= lanes * step_pairs ? step_pairs : 1;
    at = (blockIdx.x * std::size_t{step_threads} + threadIdx.x / 32 * 32) * each;
    stride = lanes * each;
  }
  // The index of this lane's pair k; n or more if it has no such pair.
  __device__ unsigned long long index(unsigned k) const { return k < each ? at + threadIdx.x % 32 + 32 * k : n; }
};

// ---- to append ----

// lanes[k] becomes the lanes of this warp whose bit k is marked. Returns the number of all marks.
template <int Each> __device__ inline unsigned marked(unsigned marks, unsigned (&lanes)[Each]) {
  unsigned total = 0;
#pragma unroll
  for (int k = 0; k < Each; ++k) {
    lanes[k] = __ballot_sync(~0U, marks >> k & 1);
    total += __popc(lanes[k]);
  }
  return total;
}

// Appends the marked pairs of all lanes of this warp, at most Each of them for a lane; bit k of `marks` stands for pair
// k. The warp makes one addition, because additions to one counter are carried out one at a time.
template <int Each>
__device__ inline void append(unsigned marks, const index_pair (&pairs)[Each], const pair_list &to) {
  const unsigned lane = threadIdx.x % 32;
  unsigned lanes[Each];
  const unsigned total = marked(marks, lanes);
  if (total == 0)
    return;
  unsigned long long at = 0;
  if (lane == 0)
    at = atomicAdd(to.count, static_cast<unsigned long long>(total));
  at = __shfl_sync(~0U, at, 0);
#pragma unroll
  for (int k = 0; k < Each; ++k) {
    const unsigned long long place = at + __popc(lanes[k] & ((1U << lane) - 1));
    if ((marks >> k & 1) && place < to.capacity)
      to.pairs[place] = pairs[k];
    at += __popc(lanes[k]);
  }
}

// The same pairs the other way round; of those of an element with itself the marks are cleared.
template <int Each>
__device__ inline unsigned turned(unsigned marks, const index_pair (&pairs)[Each], index_pair (&out)[Each]) {
#pragma unroll
  for (int k = 0; k < Each; ++k) {
    out[k] = {pairs[k].b, pairs[k].a};
    marks &= ~(static_cast<unsigned>(pairs[k].a == pairs[k].b) << k);
  }
  return marks;
}
template <int Each>
__device__ inline void append_hits(unsigned marks, const index_pair (&pairs)[Each], const pair_list &to) {
  append(marks, pairs, to);
  if (to.both_ways) {
    index_pair other[Each];
    const unsigned others = turned(marks, pairs, other);
    append(others, other, to);
  }
}

// Pairs of one warp that wait in shared memory until there are many, because additions to one counter are carried out one at
// a time. All functions are of the whole warp.
inline constexpr unsigned waiting_pairs = 512;
template <unsigned Size = waiting_pairs> class waiting_list {
public:
  __device__ waiting_list(const pair_list &to, index_pair *room) : to_(to), room_(room) {}

  // Appends the marked pairs of all lanes, at most Each of them for a lane; bit k of `marks` stands for pair k.
  template <int Each> __device__ void append(unsigned marks, const index_pair (&pairs)[Each]) {
    put(marks, pairs);
    if (to_.both_ways) {
      index_pair other[Each];
      const unsigned others = turned(marks, pairs, other);
      put(others, other);
    }
  }
  __device__ void flush() {
    if (n_ == 0)
      return;
    unsigned long long at = 0;
    if (threadIdx.x % 32 == 0)
      at = atomicAdd(to_.count, static_cast<unsigned long long>(n_));
    flush(__shfl_sync(~0U, at, 0));
  }
  // The last flush of all warps of a block, which all call it, with one addition.
  template <unsigned Warps> __device__ void flush_block() {
    __shared__ unsigned left[Warps];
    __shared__ unsigned long long first;
    const unsigned warp = threadIdx.x / 32;
    if (threadIdx.x % 32 == 0)
      left[warp] = n_;
    __syncthreads();
    unsigned all = 0, before = 0;
    for (unsigned w = 0; w < Warps; ++w)
      all += left[w], before += w < warp ? left[w] : 0;
    if (threadIdx.x == 0)
      first = all > 0 ? atomicAdd(to_.count, static_cast<unsigned long long>(all)) : 0;
    __syncthreads();
    flush(first + before);
  }

private:
  __device__ void flush(unsigned long long at) {
    __syncwarp();
    for (unsigned i = threadIdx.x % 32; i < n_ && at + i < to_.capacity; i += 32)
      to_.pairs[at + i] = room_[i];
    n_ = 0;
    __syncwarp();
  }
  template <int Each> __device__ void put(unsigned marks, const index_pair (&pairs)[Each]) {
    static_assert(32 * Each <= Size);
    const unsigned lane = threadIdx.x % 32;
    unsigned lanes[Each];
    if (n_ + marked(marks, lanes) > Size)
      flush();
#pragma unroll
    for (int k = 0; k < Each; ++k) {
      if (marks >> k & 1)
        room_[n_ + __popc(lanes[k] & ((1U << lane) - 1))] = pairs[k];
      n_ += __popc(lanes[k]);
    }
  }

  const pair_list &to_;
  index_pair *room_;
  unsigned n_ = 0;
};

__device__ inline void write(const pair_list &to, unsigned long long at, std::uint32_t a, std::uint32_t b) {
  if (at < to.capacity)
    to.pairs[at] = {a, b};
}

// Whether the list is full; all lanes of a warp get the same answer.
__device__ inline bool full(const pair_list &l) {
  return __shfl_sync(~0U, *static_cast<volatile unsigned long long *>(l.count), 0) > l.capacity;
}

} // namespace meetc::cuda

#endif
