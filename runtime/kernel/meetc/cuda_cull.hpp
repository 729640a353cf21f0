// Two sets are culled on the device before they are put into order: see cull_grid.hpp. Included by nvcc only.
#ifndef MEETC_CUDA_CULL_HPP
#define MEETC_CUDA_CULL_HPP

#include <meetc/cuda_launch.hpp>
#include <meetc/cuda_sets.hpp>
#include <meetc/cuda_warp.hpp>
#include <meetc/cull_grid.hpp>

namespace meetc::cuda {

inline constexpr unsigned cull_threads = 256, cull_warps = cull_threads / 32;

// A vertex of a kind that consists of points.
struct vertex_shape {
  static constexpr int fields = 3;
  MEETC_HD static constexpr role role_of(int field) { return field == 0 ? role::x : field == 1 ? role::y : role::z; }
  MEETC_HD static constexpr bool obeys(const float *) { return true; }
};
MEETC_HD inline tree_box box_around(const float *point) {
  tree_box b;
  for (int k = 0; k < 3; ++k)
    b.low[k] = b.high[k] = point[k];
  return b;
}

// Of elements with an index all vertices are enclosed, in one pass; the box may be larger than that of the elements.
template <class Shape>
__global__ void __launch_bounds__(cull_threads) surround_kernel(view v, pose_matrix at, joined_box *around) {
  begin();
  __shared__ std::uint32_t below[3][cull_warps], above[3][cull_warps];
  const bool of_vertices = v.index != nullptr;
  view vertices{v.data, v.stride_bytes, nullptr, 0, v.vertices};
  const std::uint32_t n = of_vertices ? v.vertices : v.elements;
  tree_box all; // empty
  for (std::size_t i = blockIdx.x * std::size_t{cull_threads} + threadIdx.x; i < n;
       i += gridDim.x * std::size_t{cull_threads}) {
    float row[Shape::fields < 3 ? 3 : Shape::fields];
    if (of_vertices) {
      if (posed_element<vertex_shape>(vertices, at, static_cast<std::uint32_t>(i), row))
        all.widen(box_around(row));
    } else {
      posed_element<Shape>(v, at, static_cast<std::uint32_t>(i), row);
      all.widen(box_of_row<Shape>(row));
    }
  }
  all = around_warp(all);
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32;
  if (lane < 3) {
    const bool some = all.low[lane] <= all.high[lane];
    below[lane][warp] = some ? below_of(all.low[lane]) : 0, above[lane][warp] = some ? above_of(all.high[lane]) : 0;
  }
  __syncthreads();
  if (threadIdx.x >= 6)
    return;
  const unsigned axis = threadIdx.x % 3;
  std::uint32_t most = 0;
  for (unsigned w = 0; w < cull_warps; ++w) {
    const std::uint32_t of = threadIdx.x < 3 ? below[axis][w] : above[axis][w];
    most = of > most ? of : most;
  }
  if (most > 0)
    atomicMax(threadIdx.x < 3 ? around->below + axis : around->above + axis, most);
}
template <class Shape>
cudaError_t surround(const view &v, const pose_matrix &at, joined_box *around, cudaStream_t stream) {
  if (v.elements == 0)
    return cudaSuccess;
  if (!can_be_indexed<Shape>(v))
    return cudaErrorInvalidValue;
  const std::size_t wanted = ((v.index ? v.vertices : v.elements) - std::size_t{1}) / cull_threads + 1;
  const unsigned most = blocks_at_once<surround_kernel<Shape>, cull_threads>();
  return launch<surround_kernel<Shape>>(static_cast<unsigned>(std::min<std::size_t>(wanted, most)), cull_threads,
                                        stream, v, at, around);
}

// A bit that is set already is not set again: most are, and atomics are slow.
__device__ inline void set_marks(std::uint32_t *word, std::uint32_t mask) {
  if ((*static_cast<volatile std::uint32_t *>(word) & mask) != mask)
    atomicOr(word, mask);
}

// The whole warp marks the cells along the lines of the lanes in `lines`.
__device__ inline void mark_lines(const cull_grid &grid, const cull_marks &marks, const line_ends &mine,
                                  unsigned lines) {
  for (; lines; lines &= lines - 1) {
    const unsigned of = __ffs(lines) - 1;
    line_ends all;
    for (int k = 0; k < 3; ++k)
      all.from[k] = __shfl_sync(~0U, mine.from[k], of), all.to[k] = __shfl_sync(~0U, mine.to[k], of);
    all.radius = __shfl_sync(~0U, mine.radius, of);
    const cull_line line(grid, all);
    const std::uint32_t last = line.last_slab(grid);
    for (std::uint32_t slab = line.first_slab(grid) + threadIdx.x % 32; slab <= last; slab += 32)
      marks.mark(line.in_slab(grid, slab), 0, set_marks);
  }
}

// A block looks at cull_tile elements at a time, and adds those that it keeps to the list with one addition.
inline constexpr unsigned cull_each = 4, cull_tile = cull_threads * cull_each;
template <class Shape>
__global__ void __launch_bounds__(cull_threads) sift_kernel(const __grid_constant__ sift_job job) {
  begin();
  __shared__ cull_grid grid;
  __shared__ std::uint32_t kept[cull_tile];
  __shared__ unsigned count, place;
  const std::size_t n = job.among ? *job.among_count : job.from.elements;
  if (threadIdx.x == 0)
    grid = cull_grid(job.around[0], job.around[1], job.bits), count = 0;
  __syncthreads();
  const cull_marks marked{job.marked, job.bits}, marks{job.marks, job.bits};
  for (std::size_t tile = blockIdx.x * std::size_t{cull_tile}; tile < n; tile += gridDim.x * std::size_t{cull_tile}) {
    for (unsigned k = 0; k < cull_each; ++k) {
      const std::size_t at = tile + k * cull_threads + threadIdx.x;
      bool keep = false, by_line = false;
      line_ends ends{};
      float row[Shape::fields];
      if (at < n) {
        const std::uint32_t number = job.among ? job.among[at] : static_cast<std::uint32_t>(at);
        if (!posed_element<Shape>(job.from, job.at, number, row))
          atomicMax(job.bad, ~(static_cast<unsigned long long>(number) << 32 | number));
        const tree_box box = box_of_row<Shape>(row);
        keep = box.touches(grid.common);
        if (keep) {
          const cell_range cells = grid.range(box);
          const int level = cull_grid::level_of(cells);
          if constexpr (Shape::hull == 2) {
            ends = ends_of_line<Shape>(row);
            by_line = job.by_lines && level > 0 && cull_line(grid, ends).is_thin();
          }
          keep = !job.marked || by_line || marked.meets(cells, level);
          if (keep && job.marks && !by_line)
            marks.mark(cells, level, set_marks);
        }
        if (keep)
          kept[atomicAdd(&count, 1U)] = number;
      }
      if constexpr (Shape::hull == 2)
        if (const unsigned lines = __ballot_sync(~0U, by_line && job.marks); lines)
          mark_lines(grid, marks, ends, lines);
    }
    __syncthreads();
    const unsigned all = count;
    if (threadIdx.x == 0)
      place = all > 0 ? atomicAdd(job.count, all) : 0;
    __syncthreads();
    for (unsigned i = threadIdx.x; i < all; i += cull_threads)
      job.kept[place + i] = kept[i];
    if (threadIdx.x == 0)
      count = 0;
    __syncthreads();
  }
}
template <class Shape> cudaError_t sift(const sift_job &job, cudaStream_t stream) {
  if (job.from.elements == 0)
    return cudaSuccess;
  if (!can_be_indexed<Shape>(job.from) || job.bits < least_cull_bits || job.bits > most_cull_bits)
    return cudaErrorInvalidValue;
  const std::size_t wanted = (job.from.elements - std::size_t{1}) / cull_tile + 1;
  const unsigned most = blocks_at_once<sift_kernel<Shape>, cull_threads>();
  return launch<sift_kernel<Shape>>(static_cast<unsigned>(std::min<std::size_t>(wanted, most)), cull_threads, stream,
                                    job);
}

} // namespace meetc::cuda

#endif
