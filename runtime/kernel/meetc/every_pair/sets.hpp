// Work on sets that are filtered: their extent, the columns that a filter reads, and the boxes of the pairs that it keeps.
// Included by nvcc only.
#ifndef MEETC_EVERY_PAIR_SETS_HPP
#define MEETC_EVERY_PAIR_SETS_HPP

#include <meetc/cuda/lists.hpp>
#include <meetc/every_pair/table.hpp>

#include <algorithm>
#include <type_traits>

namespace meetc::every_pair {

inline constexpr int set_threads = 128;

static __global__ void clear_extent_kernel(extent *around) {
  clear(*around, static_cast<int>(threadIdx.x));
}

__device__ inline extent joined_in_warp(extent mine) {
  for (int d = 16; d > 0; d /= 2)
    for (int k = 0; k < 3; ++k) {
      mine.low[k] = min(mine.low[k], __shfl_xor_sync(~0U, mine.low[k], d));
      mine.high[k] = max(mine.high[k], __shfl_xor_sync(~0U, mine.high[k], d));
    }
  return mine;
}
__device__ inline extent no_extent() {
  extent e;
  for (int k = 0; k < 3; ++k)
    clear(e, k);
  return e;
}
__device__ inline extent extent_of(const interval (&mine)[3]) {
  extent e;
  for (int k = 0; k < 3; ++k)
    e.low[k] = ordered(mine[k].lo), e.high[k] = ordered(mine[k].hi);
  return e;
}
// The extent of what a block's threads bring, which all call it; the first warp gets it.
template <unsigned Threads> __device__ extent joined_in_block(const extent &mine) {
  __shared__ extent of_warps[Threads / 32];
  const unsigned lane = threadIdx.x % 32;
  const extent warp = joined_in_warp(mine);
  if (lane == 0)
    of_warps[threadIdx.x / 32] = warp;
  __syncthreads();
  return threadIdx.x < 32 ? joined_in_warp(lane < Threads / 32 ? of_warps[lane] : no_extent()) : warp;
}

template <class Shape>
__global__ void __launch_bounds__(set_threads) enclose_kernel(const float *rows, unsigned n, extent *around) {
  interval mine[3];
  for (unsigned i = blockIdx.x * set_threads + threadIdx.x; i < n; i += gridDim.x * set_threads)
    widen<Shape>(mine, rows + i * std::size_t{Shape::fields});
  const extent all = joined_in_block<set_threads>(extent_of(mine));
  if (threadIdx.x == 0)
    for (int k = 0; k < 3; ++k)
      atomicMin(&around->low[k], all.low[k]), atomicMax(&around->high[k], all.high[k]);
}
template <class Shape> cudaError_t enclose(const float *rows, std::uint32_t n, extent *around, cudaStream_t stream) {
  const cudaError_t e = cuda::launch_after<clear_extent_kernel>(1, 3, stream, around);
  if (e != cudaSuccess || n == 0)
    return e;
  const unsigned blocks = std::min((n + set_threads - 1) / set_threads, 1056U); // all change the same numbers
  return cuda::launch_after<enclose_kernel<Shape>>(blocks, set_threads, stream, rows, n, around);
}

// Writes the padding too.
template <class Shape, class Form, bool First, bool Halves>
__global__ void __launch_bounds__(set_threads)
    columns_kernel(cover c, const float *rows, unsigned n, const extent *around, void *columns) {
  const unsigned i = blockIdx.x * set_threads + threadIdx.x; // the grid is as long as the padded array
  double ball[4] = {0, 0, 0, 0};
  placing where = placing::nowhere;
  if (i < n)
    where = place_element<Shape>(frame_of(*around), c, rows + i * std::size_t{Shape::fields}, ball);
  if constexpr (Halves) {
    alignas(16) std::uint16_t out[matrix_columns];
    to_columns<Form, First>(ball, where, out);
    auto *to = static_cast<std::uint16_t *>(columns);
    for (int k = 0; k < matrix_columns; k += 8)
      *reinterpret_cast<uint4 *>(to + matrix_place(i, k)) = *reinterpret_cast<const uint4 *>(out + k);
  } else {
    static_assert((Form::products + 1) * sizeof(float) == float_bytes);
    float out[Form::products + 1];
    to_floats<Form, First>(ball, where, out);
    for (int k = 0; k <= Form::products; ++k)
      static_cast<float *>(columns)[i * std::size_t{Form::products + 1} + k] = out[k];
  }
}
template <class Shape, class Form>
cudaError_t columns(filter by, cover c, bool first, const float *rows, std::uint32_t n, const extent *around, void *out,
                    cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const unsigned blocks = static_cast<unsigned>((matrix_padded(n) + set_threads - 1) / set_threads);
  const auto start = [&]<bool First, bool Halves>(std::bool_constant<First>, std::bool_constant<Halves>) {
    return cuda::launch_after<columns_kernel<Shape, Form, First, Halves>>(blocks, set_threads, stream, c, rows, n,
                                                                          around, out);
  };
  if (by != filter::float32)
    return first ? start(std::true_type(), std::true_type()) : start(std::false_type(), std::true_type());
  return first ? start(std::true_type(), std::false_type()) : start(std::false_type(), std::false_type());
}

static __global__ void __launch_bounds__(cuda::step_threads)
    touching_kernel(boxes_of_two boxes, cuda::pair_list in, cuda::pair_list out) {
  cuda::begin();
  __shared__ index_pair rooms[cuda::step_warps][cuda::waiting_pairs];
  cuda::waiting_list<> kept(out, rooms[threadIdx.x / 32]);
  const auto box = [](const cuda::tree_node *of, std::uint32_t slot) {
    return cuda::box_of(of[slot / cuda::tree_width], slot % cuda::tree_width);
  };
  for (cuda::list_share w(in); w.at < w.n; w.at += w.stride) {
    index_pair p[cuda::step_pairs] = {};
    unsigned keep = 0;
#pragma unroll
    for (int k = 0; k < cuda::step_pairs; ++k)
      if (w.index(k) < w.n) {
        p[k] = in.pairs[w.index(k)];
        keep |= static_cast<unsigned>(box(boxes.a, p[k].a).touches(box(boxes.b, p[k].b))) << k;
      }
    kept.append(keep, p);
  }
  kept.flush_block<cuda::step_warps>();
}
inline cudaError_t touching(const boxes_of_two &boxes, cuda::pair_list in, cuda::pair_list out, cudaStream_t stream) {
  return cuda::launch_step<touching_kernel>(stream, boxes, in, out);
}

} // namespace meetc::every_pair

#endif
