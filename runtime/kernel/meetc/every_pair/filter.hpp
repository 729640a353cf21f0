// Pairs whose enclosing balls may touch, by a matrix product of signs.
//
// The sign bits of all results of a tile are OR-ed and tested once. Only a tile with a sign set is computed again, and
// its pairs are appended to the list. See matrix.hpp for what a sign proves and table.hpp for the interface.
// Included by nvcc only.
#ifndef MEETC_EVERY_PAIR_FILTER_HPP
#define MEETC_EVERY_PAIR_FILTER_HPP

#include <meetc/every_pair/units.hpp>

namespace meetc::every_pair {

// ---- float32 ----

inline constexpr int float_threads = 128, float_group = 8;

// Each thread holds one X. The signs are tested once for eight Y.
template <class Form>
__global__ void __launch_bounds__(float_threads)
    float_kernel(const float *a, const float *b, cuda::part of, unsigned chunk, cuda::pair_list out) {
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
        continue; // the same for the whole warp
      unsigned bits = 0;
#pragma unroll
      for (unsigned k = 0; k < float_group; ++k)
        bits |= __float_as_uint(bilinear<Form>(x, y + (j + k) * n)) >> 31 << k;
      append_bits(of, bits, out, [&](unsigned k) { return index_pair{i, at + j + k}; });
    }
  }
}

// ---- launching ----

inline constexpr unsigned filter_blocks = 4096; // enough to keep any device busy to the end

// How many of the `tiles` of Y one of blocks_a blocks of X takes: a multiple of `whole`.
inline unsigned chunk_of(unsigned blocks_a, unsigned tiles, unsigned whole, unsigned most) {
  const unsigned chunks = (filter_blocks + blocks_a - 1) / blocks_a;
  unsigned chunk = (tiles + chunks - 1) / chunks;
  chunk = chunk > most ? most : chunk;
  chunk = (chunk + whole - 1) / whole * whole;
  const unsigned least = (tiles + 65534) / 65535; // a grid has 65,535 rows
  return chunk < least ? (least + whole - 1) / whole * whole : chunk;
}

template <int Rows, int Steps>
cudaError_t launch_mma(const operand &a, const operand &b, const cuda::part &of, cuda::pair_list out,
                       cudaStream_t stream) {
  constexpr unsigned rows = mma_warps * 16 * Rows;
  const unsigned blocks = (of.end_a - of.first_a + rows - 1) / rows;
  const unsigned tiles = (of.end_b - of.first_b + 7) / 8, chunk = chunk_of(blocks, tiles, Steps, 512);
  mma_kernel<Rows, Steps><<<dim3(blocks, (tiles + chunk - 1) / chunk), mma_warps * 32, 0, stream>>>(
      static_cast<const uint2 *>(a.columns), static_cast<const uint2 *>(b.columns), of, chunk, out);
  return cudaGetLastError();
}

template <class Form>
cudaError_t candidates(filter by, const operand &a, const operand &b, cuda::part of, cuda::pair_list out,
                       cudaStream_t stream) {
  if (of.first_a >= of.end_a || of.first_b >= of.end_b)
    return cudaSuccess;
  if (of.first_a % part_step != 0 || of.first_b % part_step != 0 || of.end_a > a.elements || of.end_b > b.elements)
    return cudaErrorInvalidValue;
  const unsigned rows = of.end_a - of.first_a;
  if (by == filter::float32) {
    const unsigned blocks = (rows + float_threads - 1) / float_threads, n = of.end_b - of.first_b;
    const unsigned chunk = chunk_of(blocks, n, float_threads, 1 << 14);
    float_kernel<Form><<<dim3(blocks, (n + chunk - 1) / chunk), float_threads, 0, stream>>>(
        static_cast<const float *>(a.columns), static_cast<const float *>(b.columns), of, chunk, out);
    return cudaGetLastError();
  }
  if (by != filter::mma && by != filter::wgmma)
    return cudaErrorInvalidValue;
  // Few X do not justify the registers of a whole block.
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
  wgmma_kernel<><<<grid, 128, 0, stream>>>(x, y, of, chunk, out);
  return cudaGetLastError();
}

} // namespace meetc::every_pair

#endif
