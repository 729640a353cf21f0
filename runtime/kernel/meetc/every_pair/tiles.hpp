// How kernels that compute tiles of pairs append those that they keep. Included by nvcc only.
#ifndef MEETC_EVERY_PAIR_TILES_HPP
#define MEETC_EVERY_PAIR_TILES_HPP

#include <meetc/cuda/lists.hpp>
#include <meetc/every_pair/table.hpp>

namespace meetc::every_pair {

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

// Drops the bits of pairs outside the part, since kernels compute whole tiles. pair(i) is the pair of bit i.
template <class Pair> __device__ inline unsigned within(const cuda::part &of, unsigned bits, Pair &&pair) {
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
__device__ inline void append_bits(const cuda::part &of, unsigned bits, const cuda::pair_list &to, Pair &&pair) {
  bits = within(of, bits, pair);
  for (unsigned long long at = places(__popc(bits), to.count); bits; bits &= bits - 1, ++at) {
    const index_pair p = pair(__ffs(bits) - 1);
    write(to, at, p.a, p.b);
  }
}

} // namespace meetc::every_pair

#endif
