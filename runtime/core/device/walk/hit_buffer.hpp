// core/device/walk/hit_buffer.hpp: the pairs that one warp of a walk has found wait in shared memory until there are many.
#ifndef MEETC_CORE_DEVICE_WALK_HIT_BUFFER_HPP
#define MEETC_CORE_DEVICE_WALK_HIT_BUFFER_HPP

#include "meet/core/device/walk/walk_kernels.hpp"
#include "meetc/cuda/lists.hpp"

namespace meetc::cuda {

inline constexpr unsigned hits_size = 128;

// Reserves so many places in the list of hits. One thread calls it.
__device__ inline unsigned long long reserve(const tree_walk &w, unsigned long long n) {
  if (w.near)
    atomicAdd(w.near, n);
  return atomicAdd(w.out.count, n);
}

// All functions are of the whole warp.
// BothWays: a pair is put into the list in both orders, unless an element is paired with itself.
template <bool BothWays> class hit_buffer {
public:
  __device__ hit_buffer(const tree_walk &w, index_pair (&room)[hits_size]) : w_(w), room_(room) {}

  // The pairs of the lanes where one is found: an element of the walker, and one of the tree.
  __device__ void add(bool found, std::uint32_t walker, std::uint32_t other) {
    const unsigned lanes = __ballot_sync(~0U, found), n = __popc(lanes);
    if (n_ + n > hits_size)
      flush();
    if (found)
      room_[n_ + before_this(lanes)] = {walker, other};
    n_ += n;
  }

  // Whether the list is known to be too short.
  __device__ bool over() const { return over_; }

  // How many places in the list it takes what is left in the buffer.
  __device__ unsigned entries() const {
    if constexpr (!BothWays)
      return n_;
    __syncwarp();
    unsigned all = n_;
    for (unsigned first = 0; first < n_; first += tree_width)
      all += __popc(__ballot_sync(~0U, is_turned(first + lane())));
    return all;
  }
  // Appends it, to the place `at` if that has been reserved.
  __device__ void flush() {
    const unsigned n = entries();
    unsigned long long at = 0;
    if (lane() == 0 && n > 0)
      at = reserve(w_, n);
    at = __shfl_sync(~0U, at, 0);
    over_ = at + n > w_.out.capacity;
    flush(at);
  }
  __device__ void flush(unsigned long long at) {
    __syncwarp();
    for (unsigned first = 0; first < n_; first += tree_width) {
      const unsigned i = first + lane();
      const index_pair p = i < n_ ? room_[i] : index_pair{}, q{p.b, p.a};
      const index_pair of_sets = w_.swapped ? q : p;
      if (i < n_ && w_.out.pairs)
        write(w_.out, at + lane(), of_sets.a, of_sets.b);
      at += n_ - first < tree_width ? n_ - first : tree_width;
      if constexpr (BothWays) {
        const unsigned turned = __ballot_sync(~0U, is_turned(i));
        if ((turned >> lane() & 1) && w_.out.pairs)
          write(w_.out, at + before_this(turned), q.a, q.b);
        at += __popc(turned);
      }
    }
    n_ = 0;
    __syncwarp();
  }

private:
  __device__ static unsigned lane() { return threadIdx.x % tree_width; }
  __device__ static unsigned before_this(unsigned lanes) { return __popc(lanes & ((1U << lane()) - 1)); }
  __device__ bool is_turned(unsigned i) const { return i < n_ && room_[i].a != room_[i].b; }

  const tree_walk &w_;
  index_pair (&room_)[hits_size];
  unsigned n_ = 0;
  bool over_ = false;
};

} // namespace meetc::cuda

#endif
