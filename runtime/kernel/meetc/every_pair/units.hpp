// The filters' kernels on matrix units: a warp or warpgroup keeps the columns of many X in registers and streams those
// of Y past them. See matrix.hpp for what a sign proves. Included by nvcc only.
#ifndef MEETC_EVERY_PAIR_UNITS_HPP
#define MEETC_EVERY_PAIR_UNITS_HPP

#include <meetc/every_pair/tiles.hpp>

#if defined(__CUDA_ARCH_FEAT_SM90_ALL)
#define MEETC_HAS_WGMMA 1
#else
#define MEETC_HAS_WGMMA 0
#endif

namespace meetc::every_pair {

// ---- mma.sync ----

// The results of 16 X by 8 Y. Lane 4 g + t holds those of X g and g + 8 (bit 1 of the index) by Y 2 t and 2 t + 1 (bit
// 0).
struct mma_results {
  unsigned d[4]; // bit patterns of floats
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
// The piece of a tile of 8 elements that this lane reads: columns 4 t .. 4 t + 3 of element g. Both operands number their
// columns in this way.
__device__ inline unsigned mma_piece() {
  const unsigned lane = threadIdx.x % 32, g = lane / 4, t = lane % 4;
  return t / 2 * 16 + g * 2 + t % 2;
}

inline constexpr int mma_warps = 4;

// A warp holds Rows tiles of 16 X, and tests the signs once for Steps tiles of 8 Y. Indices count tiles of 8.
template <int Rows, int Steps>
__global__ void __launch_bounds__(mma_warps * 32)
    mma_kernel(const uint2 *a, const uint2 *b, cuda::part of, unsigned chunk, cuda::pair_list out) {
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
// Multiplies 64 X, in registers, by 64 Y, in shared memory as 16 rows of 8 pieces of 16 bytes. Nothing is added to the
// products.
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
__device__ inline void wgmma_begin() {
  asm volatile("wgmma.fence.sync.aligned;" ::: "memory");
}
__device__ inline void wgmma_commit() {
  asm volatile("wgmma.commit_group.sync.aligned;" ::: "memory");
}
template <int Behind> __device__ inline void wgmma_wait() {
  asm volatile("wgmma.wait_group.sync.aligned %0;" ::"n"(Behind) : "memory");
}
// The results are valid only after the wait, which names no register. This keeps the compiler from reading them
// earlier.
__device__ inline void settle(float (&d)[32]) {
#pragma unroll
  for (int i = 0; i < 32; ++i)
    asm volatile("" : "+f"(d[i])::"memory");
}
// The descriptor without swizzle: pieces of 128 bytes; the next 8 columns follow after 128 bytes, the next 8 elements
// after 256.
__device__ inline unsigned long long wgmma_operand(const void *shared) {
  const auto at = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  return static_cast<unsigned long long>((at & 0x3ffff) >> 4) | 8ULL << 16 | 16ULL << 32;
}
#endif

inline constexpr int wgmma_rows = 8; // tiles of 64 X in a block
static_assert(matrix_block == 64 * wgmma_rows);

// A block is a warpgroup. Tiles of 64 Y pass through shared memory, two at a time. It is a template so that a header may hold
// it.
template <int = 0>
__global__ void __launch_bounds__(128)
    wgmma_kernel([[maybe_unused]] const unsigned *a, [[maybe_unused]] const uint4 *b, [[maybe_unused]] cuda::part of,
                 [[maybe_unused]] unsigned chunk, [[maybe_unused]] cuda::pair_list out) {
#if MEETC_HAS_WGMMA
  __shared__ __align__(128) uint4 tiles[2][128];
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32, g = lane / 4, t = lane % 4;
  const unsigned row = of.first_a / 8 + blockIdx.x * 8 * wgmma_rows; // in tiles of 8
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
    unsigned rows = 0; // bit r: some result of row r is negative
    float d[2][32];
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
      for (unsigned i = 0; i < 32; i += 4) {
        even = or3(even, __float_as_uint(d[r % 2][i]), __float_as_uint(d[r % 2][i + 1]));
        odd = or3(odd, __float_as_uint(d[r % 2][i + 2]), __float_as_uint(d[r % 2][i + 3]));
      }
      rows |= ((even | odd) & 0x80000000U) != 0 ? 1U << r : 0;
    }
    rows = __reduce_or_sync(~0U, rows);
    if (rows && full(out))
      rows = 0;
    // These rows are computed again by mma.sync, which is as good a filter and lets the kernel keep fewer registers.
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
  // This is not code for sm_90a: the caller has not asked the probe. A count that is too large is noticed; lost pairs
  // are not.
  if (threadIdx.x == 0)
    atomicMax(out.count, ~0ULL);
#endif
}

} // namespace meetc::every_pair

#endif
