// Two sets are culled on the device before they are put into order: see cull_grid.hpp. Included by nvcc only.
#ifndef MEETC_CUDA_CULL_HPP
#define MEETC_CUDA_CULL_HPP

#include <meetc/cuda/cull_grid.hpp>
#include <meetc/cuda/grid.hpp>
#include <meetc/cuda/sets.hpp>
#include <meetc/cuda/warp.hpp>

namespace meetc::cuda {

inline constexpr unsigned cull_threads = 256, cull_warps = cull_threads / 32;

// As many blocks as that many threads take, up to those that the device runs at once.
template <auto Kernel> unsigned blocks_to_cull(std::size_t threads) {
  const std::size_t wanted = (threads + cull_threads - 1) / cull_threads;
  return static_cast<unsigned>(std::min<std::size_t>(wanted, blocks_at_once<Kernel, cull_threads>()));
}

// A vertex of a kind that consists of points.
struct vertex_shape {
  static constexpr int fields = 3;
  MEETC_HD static constexpr role role_of(int field) { return field == 0 ? role::x : field == 1 ? role::y : role::z; }
  MEETC_HD static constexpr bool obeys(const float *) { return true; }
};
// Whether an element's box is that around its vertices.
template <class Shape> constexpr bool is_hull_of_vertices() {
  return Shape::pad < 0 && Shape::hull > 2 && Shape::fields == 3 * Shape::hull;
}

// The cells of some elements of a thread, whose memory is on its way at once.
inline constexpr unsigned cull_each = 2;
struct sifted {
  std::uint32_t number;
  cell_range cells;
  bool there, good, meets; // an element at all, one of its kind, and one that meets a cell
};

// The cells of elements whose vertices have known cells.
template <class Shape>
__device__ void cells_by_vertices(const sift_job &job, const cull_grid &grid, sifted (&all)[cull_each]) {
  constexpr unsigned points = Shape::hull;
  std::uint32_t at[cull_each][points];
  packed_cells of[cull_each][points];
#pragma unroll
  for (unsigned i = 0; i < cull_each; ++i)
#pragma unroll
    for (unsigned p = 0; p < points; ++p)
      at[i][p] = all[i].there ? job.from.index[all[i].number * std::size_t{points} + p] : 0;
#pragma unroll
  for (unsigned i = 0; i < cull_each; ++i)
#pragma unroll
    for (unsigned p = 0; p < points; ++p)
      of[i][p].bits = at[i][p] < job.from.vertices ? job.vertices[at[i][p]] : no_cells;
#pragma unroll
  for (unsigned i = 0; i < cull_each; ++i) {
    std::uint32_t least[3] = {1023, 1023, 1023}, greatest[3] = {0, 0, 0};
    all[i].good = true;
#pragma unroll
    for (unsigned p = 0; p < points; ++p) {
      all[i].good &= of[i][p].bits != no_cells;
      for (int k = 0; k < 3; ++k)
        least[k] = min(least[k], of[i][p].at(k)), greatest[k] = max(greatest[k], of[i][p].at(k));
    }
    all[i].meets = grid.range(least, greatest, all[i].cells);
    if (all[i].good) { // nothing is read for a rule that looks at nothing
      const view vertices{job.from.data, job.from.stride_bytes, nullptr, 0, job.from.vertices};
      float row[Shape::fields];
      for (unsigned p = 0; p < points; ++p)
        posed_element<vertex_shape>(vertices, job.at, at[i][p], row + 3 * p);
      all[i].good = Shape::obeys(row);
    }
  }
}

template <class Shape>
__device__ void cells_by_rows(const sift_job &job, const cull_grid &grid, sifted (&all)[cull_each]) {
  for (sifted &one : all)
    if (one.there) {
      float row[Shape::fields];
      one.good = posed_element<Shape>(job.from, job.at, one.number, row);
      one.meets = grid.range(box_of_row<Shape>(row), one.cells);
    }
}

// Whether an element marks the cells along its line.
template <class Shape>
__device__ bool marks_its_line(const sift_job &job, const cull_grid &grid, std::uint32_t number) {
  if constexpr (Shape::hull == 2) {
    if (!job.by_lines)
      return false;
    float row[Shape::fields];
    posed_element<Shape>(job.from, job.at, number, row);
    return cull_line(grid, ends_of_line<Shape>(row)).is_thin(1.75); // less, since the other kernel may round otherwise
  }
  return false;
}

// Most bits are set already, and atomics that change one word are carried out one after another.
__device__ inline void set_marks(std::uint32_t *word, std::uint32_t mask) {
  if ((__ldcg(word) & mask) != mask)
    atomicOr(word, mask);
}

// The block that comes last brings what all have counted to the host. All threads of all blocks call it.
__device__ inline void bring(const sift_job::report &r) {
  __shared__ bool is_last;
  __syncthreads();
  if (threadIdx.x == 0) {
    __threadfence();
    is_last = atomicInc(r.arrived, gridDim.x - 1) == gridDim.x - 1;
    __threadfence();
  }
  __syncthreads();
  if (!is_last)
    return;
  for (unsigned i = threadIdx.x; i < r.words; i += cull_threads)
    static_cast<volatile std::uint32_t *>(r.to)[i] = __ldcg(r.from + i);
  __syncthreads();
  if (threadIdx.x == 0) {
    __threadfence_system();
    *static_cast<volatile std::uint32_t *>(r.there) = 1;
  }
}

// A block adds what it keeps to the list with one addition.
template <class Shape, bool ByVertices>
__global__ void __launch_bounds__(cull_threads, 6) sift_kernel(const __grid_constant__ sift_job job) {
  begin();
  __shared__ cull_grid grid;
  __shared__ unsigned of_warps[cull_warps], place;
  const std::size_t n = job.among ? *job.among_count : job.from.elements;
  if (threadIdx.x == 0)
    grid = cull_grid(job.around[0], job.around[1], job.bits);
  __syncthreads();
  const cull_marks marked{job.marked, job.bits}, marks{job.marks, job.bits};
  const std::uint32_t some = job.marked ? *marked.levels() : 0;
  const unsigned lane = threadIdx.x % 32, warp = threadIdx.x / 32;
  // With few elements a thread looks at one, and a tile is smaller than it could be.
  const unsigned each = n > gridDim.x * std::size_t{cull_threads} ? cull_each : 1;
  const std::size_t size = std::size_t{cull_threads} * each;
  for (std::size_t tile = blockIdx.x * size; tile < n; tile += gridDim.x * size) {
    sifted all[cull_each];
#pragma unroll
    for (unsigned i = 0; i < cull_each; ++i) {
      const std::size_t at = tile + i * cull_threads + threadIdx.x;
      all[i].there = i < each && at < n, all[i].good = true, all[i].meets = false;
      all[i].number = job.among && all[i].there ? job.among[at] : static_cast<std::uint32_t>(at);
    }
    if constexpr (ByVertices)
      cells_by_vertices<Shape>(job, grid, all);
    else
      cells_by_rows<Shape>(job, grid, all);
    unsigned keep = 0;
#pragma unroll
    for (unsigned i = 0; i < cull_each; ++i) {
      if (all[i].there && !all[i].good)
        atomicMax(job.bad, ~(static_cast<unsigned long long>(all[i].number) << 32 | all[i].number));
      if (!all[i].there || !all[i].good || !all[i].meets)
        continue;
      const int level = all[i].cells.level();
      if (job.marked && level == 0 && !marked.meets(all[i].cells, some))
        continue;
      keep |= 1U << i;
      if (job.marks && (level == 0 || !marks_its_line<Shape>(job, grid, all[i].number)))
        marks.mark(all[i].cells, level, set_marks);
    }
    const unsigned up_to = sum_up_to(__popc(keep));
    if (lane == 31)
      of_warps[warp] = up_to;
    if (!__syncthreads_or(keep != 0))
      continue;
    unsigned before = up_to - __popc(keep), of_block = 0;
    for (unsigned w = 0; w < cull_warps; ++w)
      before += w < warp ? of_warps[w] : 0, of_block += of_warps[w];
    if (threadIdx.x == 0)
      place = atomicAdd(job.count, of_block);
    __syncthreads();
    before += place;
#pragma unroll
    for (unsigned i = 0; i < cull_each; ++i)
      if (keep >> i & 1)
        job.kept[before++] = all[i].number;
  }
  if (job.at_end.there)
    bring(job.at_end);
}

// Each warp takes one of the elements that were kept, and marks the cells along its line if it is long.
template <class Shape>
__global__ void __launch_bounds__(cull_threads) lines_kernel(const __grid_constant__ sift_job job) {
  begin();
  __shared__ cull_grid grid;
  if (threadIdx.x == 0)
    grid = cull_grid(job.around[0], job.around[1], job.bits);
  __syncthreads();
  const cull_marks marks{job.marks, job.bits};
  const std::size_t n = *job.count;
  for (std::size_t i = blockIdx.x * cull_warps + threadIdx.x / 32; i < n; i += gridDim.x * cull_warps) {
    float row[Shape::fields];
    posed_element<Shape>(job.from, job.at, job.kept[i], row);
    cell_range cells;
    grid.range(box_of_row<Shape>(row), cells);
    const cull_line line(grid, ends_of_line<Shape>(row));
    if (cells.level() == 0 || !line.is_thin())
      continue;
    const std::uint32_t last = line.last_slab(grid);
    for (std::uint32_t slab = line.first_slab(grid) + threadIdx.x % 32; slab <= last; slab += 32)
      marks.each(line.in_slab(grid, slab), 0, [&](std::uint32_t word, std::uint32_t mask) {
        atomicOr(marks.of(0) + word, mask);
        return false;
      });
    set_marks(marks.levels(), 1);
  }
}

template <class Shape> cudaError_t sift(const sift_job &job, cudaStream_t stream) {
  if (job.from.elements == 0)
    return cudaSuccess;
  if (!can_be_indexed<Shape>(job.from) || job.bits < least_cull_bits || job.bits > most_cull_bits)
    return cudaErrorInvalidValue;
  const auto start = [&]<auto Kernel>(std::size_t threads) {
    return launch<Kernel>(blocks_to_cull<Kernel>(threads), cull_threads, stream, job);
  };
  if constexpr (is_hull_of_vertices<Shape>())
    if (job.from.index)
      return start.template operator()<sift_kernel<Shape, true>>(job.from.elements);
  if (const cudaError_t e = start.template operator()<sift_kernel<Shape, false>>(job.from.elements); e != cudaSuccess)
    return e;
  if constexpr (Shape::hull == 2)
    if (job.by_lines && job.marks)
      return start.template operator()<lines_kernel<Shape>>(job.from.elements * std::size_t{32});
  return cudaSuccess;
}

} // namespace meetc::cuda

#endif
