// The first stage of every all-pairs query: pairs whose enclosing balls may touch, by a matrix product of signs.
//
// A warp or warpgroup keeps the columns of many X in registers and streams those of Y past them. The results' sign
// bits are OR-ed and looked at once a tile; only a tile with a sign set is gone through again, and its pairs appended
// to the list. See matrix.hpp for what a sign proves, cuda_table.hpp for the interface. Included by nvcc alone.
#ifndef MEETC_CUDA_FILTER_HPP
#define MEETC_CUDA_FILTER_HPP

#include <meetc/cuda_table.hpp>

#if defined(__CUDA_ARCH_FEAT_SM90_ALL)
#define MEETC_HAS_WGMMA 1
#else
#define MEETC_HAS_WGMMA 0
#endif

namespace meetc::cuda {

// ---- appending ----

// The places of this lane's n entries, appended by the whole warp with one addition.
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

// Appends the pairs of this warp's lanes that are marked, up to Each of them a lane; bit k of `marks` is pair k. One
// addition for all: many lists have one counter, and it takes one at a time.
template <int Each>
__device__ inline void append(unsigned marks, const index_pair (&pairs)[Each], const pair_list &to) {
  const unsigned lane = threadIdx.x % 32;
  unsigned total = 0;
  unsigned lanes[Each];
#pragma unroll
  for (int k = 0; k < Each; ++k) {
    lanes[k] = __ballot_sync(~0U, marks >> k & 1);
    total += __popc(lanes[k]);
  }
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

__device__ inline void write(const pair_list &to, unsigned long long at, std::uint32_t a, std::uint32_t b) {
  if (at < to.capacity)
    to.pairs[at] = {a, b};
}

// Drops the bits of pairs beyond the part: kernels go through whole tiles. pair(i) is the pair of bit i.
template <class Pair> __device__ inline unsigned within(const part &of, unsigned bits, Pair &&pair) {
  unsigned kept = bits;
  for (unsigned left = bits; left; left &= left - 1) {
    const index_pair p = pair(__ffs(left) - 1);
    if (p.a >= of.end_a || p.b >= of.end_b)
      kept &= ~(left & (~left + 1));
  }
  return kept;
}
// Appends the pairs of the bits; the whole warp calls it.
template <class Pair>
__device__ inline void append_bits(const part &of, unsigned bits, const pair_list &to, Pair &&pair) {
  bits = within(of, bits, pair);
  for (unsigned long long at = places(__popc(bits), to.count); bits; bits &= bits - 1, ++at) {
    const index_pair p = pair(__ffs(bits) - 1);
    write(to, at, p.a, p.b);
  }
}

// The same for all lanes of the warp.
__device__ inline bool full(const pair_list &l) {
  return __shfl_sync(~0U, *static_cast<volatile unsigned long long *>(l.count), 0) > l.capacity;
}

// ---- mma.sync ----

// Results of 16 X by 8 Y. Lane 4 g + t holds X g and g + 8 (bit 1) by Y 2 t and 2 t + 1 (bit 0).
struct mma_results {
  unsigned d[4]; // the bits of floats
};
__device__ inline mma_results multiply(const unsigned (&a)[4], uint2 b) {
  mma_results r;
  asm volatile("mma.sync.aligned.m16n8k16.row.col.f32.f16.f16.f32 {%0,%1,%2,%3}, {%4,%5,%6,%7}, {%8,%9}, "
               "{%10,%10,%10,%10};"
               : "=r"(r.d[0]), "=r"(r.d[1]), "=r"(r.d[2]), "=r"(r.d[3])
               : "r"(a[0]), "r"(a[1]), "r"(a[2]), "r"(a[3]), "r"(b.x), "r"(b.y), "r"(0));
  return r;
}
__device__ inline unsigned or3(unsigned x, unsigned y, unsigned z) {
  asm("lop3.b32 %0, %0, %1, %2, 0xfe;" : "+r"(x) : "r"(y), "r"(z));
  return x;
}
__device__ inline unsigned sign_bits(const mma_results &r) {
  return r.d[0] >> 31 | r.d[1] >> 31 << 1 | r.d[2] >> 31 << 2 | r.d[3] >> 31 << 3;
}
// The piece of a tile of 8 objects that this lane reads: columns 4 t .. 4 t + 3 of object g. Both operands number
// their columns so.
__device__ inline unsigned mma_piece() {
  const unsigned lane = threadIdx.x % 32, g = lane / 4, t = lane % 4;
  return t / 2 * 16 + g * 2 + t % 2;
}

inline constexpr int mma_warps = 4;

// Rows tiles of 16 X a warp, Steps tiles of 8 Y between two looks at the signs. All sizes in tiles of 8.
template <int Rows, int Steps>
__global__ void __launch_bounds__(mma_warps * 32)
    mma_kernel(const uint2 *a, const uint2 *b, part of, unsigned chunk, pair_list out) {
  const unsigned lane = threadIdx.x % 32;
  const unsigned row = of.first_a / 8 + (blockIdx.x * mma_warps + threadIdx.x / 32) * 2 * Rows;
  if (row * 8 >= of.end_a)
    return;
  const unsigned piece = mma_piece();
  unsigned x[Rows][4];
#pragma unroll
  for (unsigned r = 0; r < Rows; ++r) {
    const uint2 *from = a + (row + 2 * r) * std::size_t{32} + piece;
    const uint2 low = from[0], high = from[32];
    x[r][0] = low.x, x[r][1] = high.x, x[r][2] = low.y, x[r][3] = high.y;
  }
  const unsigned begin = of.first_b / 8 + blockIdx.y * chunk, end = min((of.end_b + 7) / 8, begin + chunk);
  const uint2 *from = b + begin * std::size_t{32} + piece;
  uint2 y[Steps];
#pragma unroll
  for (unsigned s = 0; s < Steps; ++s)
    y[s] = from[s * 32];
  for (unsigned tile = begin; tile < end; tile += Steps) {
    from += Steps * 32;
    uint2 next[Steps];
#pragma unroll
    for (unsigned s = 0; s < Steps; ++s)
      next[s] = tile + Steps < end ? from[s * 32] : uint2{0, 0};
    unsigned even = 0, odd = 0;
#pragma unroll
    for (unsigned s = 0; s < Steps; ++s)
#pragma unroll
      for (unsigned r = 0; r < Rows; ++r) {
        const mma_results v = multiply(x[r], y[s]);
        unsigned &any = r % 2 ? odd : even;
        any = or3(or3(any, v.d[0], v.d[1]), v.d[2], v.d[3]);
      }
    if (__any_sync(~0U, static_cast<int>(even | odd) < 0)) {
      if (full(out))
        return;
#pragma unroll
      for (unsigned s = 0; s < Steps; ++s) {
        unsigned bits = 0;
#pragma unroll
        for (unsigned r = 0; r < Rows; ++r)
          bits |= sign_bits(multiply(x[r], y[s])) << 4 * r;
        if (__any_sync(~0U, bits != 0))
          append_bits(of, bits, out, [&](unsigned i) {
            return index_pair{row * 8 + i / 4 * 16 + lane / 4 + i / 2 % 2 * 8, (tile + s) * 8 + lane % 4 * 2 + i % 2};
          });
      }
    }
#pragma unroll
    for (unsigned s = 0; s < Steps; ++s)
      y[s] = next[s];
  }
}

// ---- wgmma ----

#if MEETC_HAS_WGMMA
// 64 X, in registers, by 64 Y, in shared memory as 16 rows of 8 pieces of 16 bytes; nothing is added to.
__device__ inline void multiply(float (&d)[32], const unsigned (&a)[4], unsigned long long y) {
  asm volatile("{\n.reg .pred add;\nsetp.ne.b32 add, 0, 0;\n"
               "wgmma.mma_async.sync.aligned.m64n64k16.f32.f16.f16 "
               "{%0,%1,%2,%3,%4,%5,%6,%7,%8,%9,%10,%11,%12,%13,%14,%15,"
               "%16,%17,%18,%19,%20,%21,%22,%23,%24,%25,%26,%27,%28,%29,%30,%31}, "
               "{%32,%33,%34,%35}, %36, add, 1, 1, 0;\n}"
               : "+f"(d[0]), "+f"(d[1]), "+f"(d[2]), "+f"(d[3]), "+f"(d[4]), "+f"(d[5]), "+f"(d[6]), "+f"(d[7]),
                 "+f"(d[8]), "+f"(d[9]), "+f"(d[10]), "+f"(d[11]), "+f"(d[12]), "+f"(d[13]), "+f"(d[14]), "+f"(d[15]),
                 "+f"(d[16]), "+f"(d[17]), "+f"(d[18]), "+f"(d[19]), "+f"(d[20]), "+f"(d[21]), "+f"(d[22]), "+f"(d[23]),
                 "+f"(d[24]), "+f"(d[25]), "+f"(d[26]), "+f"(d[27]), "+f"(d[28]), "+f"(d[29]), "+f"(d[30]), "+f"(d[31])
               : "r"(a[0]), "r"(a[1]), "r"(a[2]), "r"(a[3]), "l"(y));
}
// The same with results in half precision, two a register: half as many to look at.
__device__ inline void multiply(unsigned (&d)[16], const unsigned (&a)[4], unsigned long long y) {
  asm volatile("{\n.reg .pred add;\nsetp.ne.b32 add, 0, 0;\n"
               "wgmma.mma_async.sync.aligned.m64n64k16.f16.f16.f16 "
               "{%0,%1,%2,%3,%4,%5,%6,%7,%8,%9,%10,%11,%12,%13,%14,%15}, {%16,%17,%18,%19}, %20, add, 1, 1, 0;\n}"
               : "+r"(d[0]), "+r"(d[1]), "+r"(d[2]), "+r"(d[3]), "+r"(d[4]), "+r"(d[5]), "+r"(d[6]), "+r"(d[7]),
                 "+r"(d[8]), "+r"(d[9]), "+r"(d[10]), "+r"(d[11]), "+r"(d[12]), "+r"(d[13]), "+r"(d[14]), "+r"(d[15])
               : "r"(a[0]), "r"(a[1]), "r"(a[2]), "r"(a[3]), "l"(y));
}
__device__ inline unsigned bits_of(float x) {
  return __float_as_uint(x);
}
__device__ inline unsigned bits_of(unsigned x) {
  return x;
}
__device__ inline void wgmma_begin() {
  asm volatile("wgmma.fence.sync.aligned;" ::: "memory");
}
__device__ inline void wgmma_commit() {
  asm volatile("wgmma.commit_group.sync.aligned;" ::: "memory");
}
template <int Behind> __device__ inline void wgmma_wait() {
  asm volatile("wgmma.wait_group.sync.aligned %0;" ::"n"(Behind) : "memory");
}
// Results are there only after the wait, which names no register: without this the compiler may read them before it.
__device__ inline void settle(float (&d)[32]) {
#pragma unroll
  for (int i = 0; i < 32; ++i)
    asm volatile("" : "+f"(d[i])::"memory");
}
__device__ inline void settle(unsigned (&d)[16]) {
#pragma unroll
  for (int i = 0; i < 16; ++i)
    asm volatile("" : "+r"(d[i])::"memory");
}
// No swizzle: pieces of 128 bytes, the next 8 columns 128 bytes on, the next 8 objects 256 bytes on.
__device__ inline unsigned long long wgmma_operand(const void *shared) {
  const auto at = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  return static_cast<unsigned long long>((at & 0x3ffff) >> 4) | 8ULL << 16 | 16ULL << 32;
}
#endif

inline constexpr int wgmma_rows = 8; // times 64 X a block
static_assert(matrix_block == 64 * wgmma_rows);

// A block is a warpgroup. Tiles of 64 Y come through shared memory, two at a time in flight. Half: results in half
// precision.
template <bool Half>
__global__ void __launch_bounds__(128)
    wgmma_kernel([[maybe_unused]] const unsigned *a, [[maybe_unused]] const uint4 *b, [[maybe_unused]] part of,
                 [[maybe_unused]] unsigned chunk, [[maybe_unused]] pair_list out) {
#if MEETC_HAS_WGMMA
  __shared__ __align__(128) uint4 tiles[2][128];
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32, g = lane / 4, t = lane % 4;
  const unsigned row = of.first_a / 8 + blockIdx.x * 8 * wgmma_rows; // of tiles of 8
  unsigned x[wgmma_rows][4];
#pragma unroll
  for (unsigned r = 0; r < wgmma_rows; ++r) {
    const unsigned *from = a + (row + r * 8 + warp * 2) * std::size_t{64} + g * 4 + t;
    x[r][0] = from[0], x[r][1] = from[64], x[r][2] = from[32], x[r][3] = from[96];
  }
  const unsigned begin = of.first_b / 64 + blockIdx.y * chunk, end = min((of.end_b + 63) / 64, begin + chunk); // of 64
  const auto fetch = [&](unsigned tile, unsigned to) {
    const auto at = static_cast<unsigned>(__cvta_generic_to_shared(&tiles[to][threadIdx.x]));
    asm volatile("cp.async.cg.shared.global [%0], [%1], 16;\ncp.async.commit_group;" ::"r"(at),
                 "l"(b + tile * std::size_t{128} + threadIdx.x)
                 : "memory");
  };
  fetch(begin, 0);
  for (unsigned tile = begin, now = 0; tile < end; ++tile, now ^= 1) {
    asm volatile("cp.async.wait_group 0;\nfence.proxy.async.shared::cta;" ::: "memory");
    __syncthreads();
    if (tile + 1 < end)
      fetch(tile + 1, now ^ 1);
    const unsigned long long y = wgmma_operand(tiles[now]);
    unsigned rows = 0;                           // those with a sign set, as bits
    constexpr unsigned results = Half ? 16 : 32; // registers
    std::conditional_t<Half, unsigned, float> d[2][results];
    wgmma_begin();
    multiply(d[0], x[0], y);
    wgmma_commit();
#pragma unroll
    for (unsigned r = 0; r < wgmma_rows; ++r) {
      if (r + 1 < wgmma_rows) {
        wgmma_begin();
        multiply(d[(r + 1) % 2], x[r + 1], y);
        wgmma_commit();
        wgmma_wait<1>();
      } else {
        wgmma_wait<0>();
      }
      settle(d[r % 2]);
      unsigned even = 0, odd = 0;
#pragma unroll
      for (unsigned i = 0; i < results; i += 4) {
        even = or3(even, bits_of(d[r % 2][i]), bits_of(d[r % 2][i + 1]));
        odd = or3(odd, bits_of(d[r % 2][i + 2]), bits_of(d[r % 2][i + 3]));
      }
      rows |= ((even | odd) & (Half ? 0x80008000U : 0x80000000U)) != 0 ? 1U << r : 0;
    }
    rows = __reduce_or_sync(~0U, rows);
    if (rows && full(out))
      rows = 0;
    // Gone through again by mma.sync: as right a filter as the other, and no registers are held for it.
    for (; rows; rows &= rows - 1) {
      const unsigned r = __ffs(rows) - 1;
      unsigned again[4] = {0, 0, 0, 0};
#pragma unroll
      for (unsigned i = 0; i < wgmma_rows; ++i)
        if (i == r)
          again[0] = x[i][0], again[1] = x[i][1], again[2] = x[i][2], again[3] = x[i][3];
      const auto *from = reinterpret_cast<const unsigned *>(tiles[now]) + g * 4 + t;
      unsigned bits = 0;
#pragma unroll
      for (unsigned s = 0; s < 8; ++s)
        bits |= sign_bits(multiply(again, uint2{from[s * 64], from[s * 64 + 32]})) << 4 * s;
      if (__any_sync(~0U, bits != 0))
        append_bits(of, bits, out, [&](unsigned i) {
          return index_pair{row * 8 + r * 64 + warp * 16 + g + i / 2 % 2 * 8, tile * 64 + i / 4 * 8 + t * 2 + i % 2};
        });
    }
  }
#else
  // Not code for sm_90a: the caller has not asked the probe. A list that seems too short is noticed; lost pairs are not.
  if (threadIdx.x == 0)
    atomicMax(out.count, ~0ULL);
#endif
}

// ---- float32 ----

inline constexpr int float_threads = 128, float_group = 8;

// An X a thread; eight Y between two looks at the signs.
template <class Form>
__global__ void __launch_bounds__(float_threads)
    float_kernel(const float *a, const float *b, part of, unsigned chunk, pair_list out) {
  constexpr int n = Form::products + 1;
  __shared__ float y[float_threads * n];
  const unsigned i = of.first_a + blockIdx.x * float_threads + threadIdx.x;
  float x[n];
#pragma unroll
  for (int k = 0; k < n; ++k)
    x[k] = a[i * std::size_t{n} + k];
  const unsigned begin = of.first_b + blockIdx.y * chunk, end = min(of.end_b, begin + chunk);
  for (unsigned at = begin; at < end; at += float_threads) {
    __syncthreads();
    for (unsigned k = threadIdx.x; k < float_threads * n; k += float_threads)
      y[k] = b[at * std::size_t{n} + k];
    __syncthreads();
    for (unsigned j = 0; j < float_threads; j += float_group) {
      unsigned any = 0;
#pragma unroll
      for (unsigned k = 0; k < float_group; ++k)
        any |= __float_as_uint(bilinear<Form>(x, y + (j + k) * n));
      if (!__any_sync(~0U, static_cast<int>(any) < 0) || full(out))
        continue; // alike for the whole warp
      unsigned bits = 0;
#pragma unroll
      for (unsigned k = 0; k < float_group; ++k)
        bits |= __float_as_uint(bilinear<Form>(x, y + (j + k) * n)) >> 31 << k;
      append_bits(of, bits, out, [&](unsigned k) { return index_pair{i, at + j + k}; });
    }
  }
}

// ---- launching ----

inline constexpr unsigned filter_blocks = 4096; // enough of them to keep any device busy to the end

// Cuts `tiles` of Y into chunks for blocks_a blocks of X: a multiple of `whole`.
inline unsigned chunk_of(unsigned blocks_a, unsigned tiles, unsigned whole, unsigned most) {
  const unsigned chunks = (filter_blocks + blocks_a - 1) / blocks_a;
  unsigned chunk = (tiles + chunks - 1) / chunks;
  chunk = chunk > most ? most : chunk;
  chunk = (chunk + whole - 1) / whole * whole;
  const unsigned least = (tiles + 65534) / 65535; // a grid has 65,535 rows
  return chunk < least ? (least + whole - 1) / whole * whole : chunk;
}

template <int Rows, int Steps>
cudaError_t launch_mma(const operand &a, const operand &b, const part &of, pair_list out, cudaStream_t stream) {
  constexpr unsigned rows = mma_warps * 16 * Rows;
  const unsigned blocks = (of.end_a - of.first_a + rows - 1) / rows;
  const unsigned tiles = (of.end_b - of.first_b + 7) / 8, chunk = chunk_of(blocks, tiles, Steps, 512);
  mma_kernel<Rows, Steps><<<dim3(blocks, (tiles + chunk - 1) / chunk), mma_warps * 32, 0, stream>>>(
      static_cast<const uint2 *>(a.columns), static_cast<const uint2 *>(b.columns), of, chunk, out);
  return cudaGetLastError();
}

template <class Form>
cudaError_t candidates(filter by, const operand &a, const operand &b, part of, pair_list out, cudaStream_t stream) {
  if (of.first_a >= of.end_a || of.first_b >= of.end_b)
    return cudaSuccess;
  if (of.first_a % part_step != 0 || of.first_b % part_step != 0 || of.end_a > a.objects() || of.end_b > b.objects())
    return cudaErrorInvalidValue;
  const unsigned rows = of.end_a - of.first_a;
  if (by == filter::float32) {
    const unsigned blocks = (rows + float_threads - 1) / float_threads, n = of.end_b - of.first_b;
    const unsigned chunk = chunk_of(blocks, n, float_threads, 1 << 14);
    float_kernel<Form><<<dim3(blocks, (n + chunk - 1) / chunk), float_threads, 0, stream>>>(
        static_cast<const float *>(a.columns), static_cast<const float *>(b.columns), of, chunk, out);
    return cudaGetLastError();
  }
  if (by != filter::mma && by != filter::wgmma && by != filter::wgmma_half)
    return cudaErrorInvalidValue;
  // A few X are not worth a whole block's registers.
  if (rows <= 16)
    return launch_mma<1, 4>(a, b, of, out, stream);
  if (rows < matrix_block)
    return launch_mma<4, 4>(a, b, of, out, stream);
  if (by == filter::mma)
    return launch_mma<8, 4>(a, b, of, out, stream);
  const unsigned blocks = (rows + matrix_block - 1) / matrix_block;
  const unsigned tiles = (of.end_b - of.first_b + 63) / 64, chunk = chunk_of(blocks, tiles, 1, 256);
  const dim3 grid(blocks, (tiles + chunk - 1) / chunk);
  const auto *x = static_cast<const unsigned *>(a.columns);
  const auto *y = static_cast<const uint4 *>(b.columns);
  if (by == filter::wgmma)
    wgmma_kernel<false><<<grid, 128, 0, stream>>>(x, y, of, chunk, out);
  else
    wgmma_kernel<true><<<grid, 128, 0, stream>>>(x, y, of, chunk, out);
  return cudaGetLastError();
}

} // namespace meetc::cuda

#endif
