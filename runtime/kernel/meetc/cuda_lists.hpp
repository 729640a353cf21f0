// Lists of pairs that whole warps append to. Included by nvcc only.
#ifndef MEETC_CUDA_LISTS_HPP
#define MEETC_CUDA_LISTS_HPP

#include <meetc/cuda_table.hpp>

namespace meetc::cuda {

// Where this lane's n entries go. The whole warp reserves room with one addition.
__device__ inline unsigned long long places(unsigned n, unsigned long long *count) {
  const unsigned lane = threadIdx.x % 32;
  unsigned up_to = n;
  for (unsigned d = 1; d < 32; d *= 2) {
    const unsigned below = __shfl_up_sync(~0U, up_to, d);
    up_to += lane >= d ? below : 0;
  }
  unsigned long long at = 0;
  if (lane == 31 && up_to > 0)
    at = atomicAdd(count, static_cast<unsigned long long>(up_to));
  return __shfl_sync(~0U, at, 31) + up_to - n;
}

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

// Of one warp: pairs that wait in shared memory until there are many, because additions to one counter are carried out one at
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

// Drops the bits of pairs outside the part, since kernels compute whole tiles. pair(i) is the pair of bit i.
template <class Pair> __device__ inline unsigned within(const part &of, unsigned bits, Pair &&pair) {
  unsigned kept = bits;
  for (unsigned left = bits; left; left &= left - 1) {
    const index_pair p = pair(__ffs(left) - 1);
    if (p.a >= of.end_a || p.b >= of.end_b)
      kept &= ~(left & (~left + 1));
  }
  return kept;
}
// Appends the pairs whose bits are set. The whole warp must call it.
template <class Pair>
__device__ inline void append_bits(const part &of, unsigned bits, const pair_list &to, Pair &&pair) {
  bits = within(of, bits, pair);
  for (unsigned long long at = places(__popc(bits), to.count); bits; bits &= bits - 1, ++at) {
    const index_pair p = pair(__ffs(bits) - 1);
    write(to, at, p.a, p.b);
  }
}

// Whether the list is full; all lanes of a warp get the same answer.
__device__ inline bool full(const pair_list &l) {
  return __shfl_sync(~0U, *static_cast<volatile unsigned long long *>(l.count), 0) > l.capacity;
}

} // namespace meetc::cuda

#endif
