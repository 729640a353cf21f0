// A set's elements are put into their spatial order by one kernel. Included by nvcc only.
//
// Problem: of some hundred thousand elements a sort by digits is a chain of a dozen kernels, each of which waits more than it
// works. Method: one kernel whose blocks meet between its steps. Elements are counted by the first bits of their places, whose
// cells are as many as they are; sums of the counts say where each cell begins; and an element's rank within its cell, where
// few others are, is the number of those that come before it. The order is that of a stable sort by places.
// Limits: up to most_to_arrange elements, and no more than most_in_cell in a cell.
#ifndef MEETC_CUDA_ARRANGE_HPP
#define MEETC_CUDA_ARRANGE_HPP

#include <meetc/cuda_grid.hpp>
#include <meetc/cuda_sets.hpp>
#include <meetc/cuda_tree.hpp>
#include <meetc/tree_order.hpp>

namespace meetc::cuda {

// A box and a number for each block.
static_assert(1024 * (sizeof(tree_box) + sizeof(std::uint32_t)) <= arrange_bytes);

template <class Shape>
__global__ void __launch_bounds__(threads_to_arrange(Shape::fields))
    arrange_kernel(const __grid_constant__ arrange_job job, const __grid_constant__ tree_shape shape) {
  constexpr unsigned arrange_threads = threads_to_arrange(Shape::fields), fields = Shape::fields;
  __shared__ float rows_of_warps[arrange_threads / 32][32 * fields];
  __shared__ unsigned room[arrange_threads / 32], starts[arrange_threads];
  __shared__ unsigned long long bad_of_block, crowded_of_block, longest_of_block;
  __shared__ hilbert_cells cells;
  __shared__ shared_steps steps;
  // Warps that follow one another are in different blocks, so that few elements have many multiprocessors.
  const std::uint32_t n = job.from.elements, step = grid_threads(),
                      first = (threadIdx.x / 32 * gridDim.x + blockIdx.x) * 32 + threadIdx.x % 32;
  auto *const parts = static_cast<tree_box *>(job.parts);
  const running_sums counts{job.cells, 1U << job.cell_bits, reinterpret_cast<std::uint32_t *>(parts + arrange_threads)};
  const int place_bits = 3 * job.bits;

  // The box by which elements get places: around all rows, which are written, or around some of them.
  steps.fill<arrange_threads>();
  if (threadIdx.x == 0)
    bad_of_block = ~0ULL, crowded_of_block = 0, longest_of_block = 0;
  __syncthreads();
  const unsigned lane = threadIdx.x % 32;
  float *const of_warp = rows_of_warps[threadIdx.x / 32];
  const float *const posed = job.posed ? job.posed : job.from.data;
  tree_box mine; // empty
  const auto check_row = [&](std::uint32_t i, float(&row)[fields]) {
    if (!posed_element<Shape>(job.from, job.at, i, row))
      atomicMin(&bad_of_block, static_cast<unsigned long long>(number_in(job.from, i)) << 32 | i);
  };
  // A warp stays whole, since it writes its rows together.
  for (std::uint32_t base = first - lane; job.posed && base < n; base += step) {
    const std::uint32_t i = base + lane;
    float row[fields];
    if (i < n) {
      check_row(i, row);
      mine.widen(box_of_row<Shape>(row));
      for (unsigned f = 0; f < fields; ++f)
        of_warp[lane * fields + f] = row[f];
    }
    write_rows<Shape::fields>(of_warp, n - base, job.posed + base * std::size_t{fields});
  }
  const sample some(n);
  for (std::uint32_t i = some.first + threadIdx.x * some.step; !job.posed && i < n; i += arrange_threads * some.step)
    mine.widen(box_of_row<Shape>(posed + i * std::size_t{fields}));
  for (std::uint32_t c = first; c < counts.n; c += step)
    job.cells[c] = 0;
  tree_box around = around_block<arrange_threads>(mine);
  if (threadIdx.x == 0) {
    parts[blockIdx.x] = around;
    if (blockIdx.x == 0)
      *job.found = {~0ULL, 0, 0};
  }
  if (blockIdx.x == 0 && threadIdx.x < job.clears)
    job.cleared[threadIdx.x] = 0;
  meet_grid();
  if (job.posed)
    around = around_block<arrange_threads>(threadIdx.x < gridDim.x ? parts[threadIdx.x] : tree_box());
  if (threadIdx.x == 0)
    cells = hilbert_cells(around, job.bits);
  __syncthreads();

  // Places, and how many elements each cell has.
  for (std::uint32_t i = first; i < n; i += step) {
    float row[fields];
    if (job.posed)
      for (unsigned f = 0; f < fields; ++f)
        row[f] = posed[i * std::size_t{fields} + f];
    else
      check_row(i, row);
    const std::uint32_t place = cells.place_of(box_of_row<Shape>(row), steps.table());
    job.places[i] = place;
    job.ranks[i] = atomicAdd(job.cells + cell_of(in_order(place, i), place_bits, job.cell_bits), 1U);
  }
  meet_grid();
  counts.sum_chunk<arrange_threads>(room);
  meet_grid();

  // Elements by their cells.
  counts.sum_totals<arrange_threads>(room, starts);
  const unsigned shift = counts.shift();
  for (std::uint32_t i = first; i < n; i += step) {
    const std::uint64_t element = in_order(job.places[i], i);
    job.by_cell[counts.at(starts, shift, cell_of(element, place_bits, job.cell_bits)) + job.ranks[i]] = element;
  }
  meet_grid();

  // Elements in their order. A warp copies the rows of its elements together.
  for (std::uint32_t base = first - lane; base < n; base += step) {
    std::uint32_t from = 0, to = n; // n: there is none
    if (base + lane < n) {
      const std::uint64_t element = job.by_cell[base + lane];
      const std::uint32_t cell = cell_of(element, place_bits, job.cell_bits), begin = counts.at(starts, shift, cell),
                          end = cell + 1 < counts.n ? counts.at(starts, shift, cell + 1) : n;
      from = static_cast<std::uint32_t>(element), to = base + lane;
      if (end - begin > most_in_cell) { // each has a slot all the same
        atomicMax(&longest_of_block, static_cast<unsigned long long>(end - begin));
      } else {
        const before_in_cell before(job.by_cell, begin, end, element);
        if (before.alike >= tree_width)
          atomicAdd(&crowded_of_block, 1ULL);
        to = begin + before.all;
      }
      job.order[to] = number_in(job.from, from);
    }
    for (unsigned k = lane; k < 32 * fields; k += 32) {
      const std::uint32_t row_from = __shfl_sync(~0U, from, k / fields), row_to = __shfl_sync(~0U, to, k / fields);
      if (row_to < n)
        job.rows[row_to * std::size_t{fields} + k % fields] = posed[row_from * std::size_t{fields} + k % fields];
    }
  }
  __syncthreads();
  if (threadIdx.x == 0) {
    if (bad_of_block != ~0ULL)
      atomicMin(&job.found->bad, bad_of_block);
    if (crowded_of_block > 0)
      atomicAdd(&job.found->crowded, crowded_of_block);
    if (longest_of_block > 0)
      atomicMax(&job.found->longest, longest_of_block);
  }
  if constexpr (can_arrange_tree(Shape::fields))
    if (job.nodes) {
      meet_grid();
      put_tree<Shape>(job.rows, n, job.nodes, shape, job.arrived);
    }
}

template <class Shape> cudaError_t arrange(const arrange_job &job, cudaStream_t stream) {
  if (job.from.elements == 0 || job.from.elements > most_to_arrange || job.cell_bits > 3 * job.bits ||
      !(job.share > 0 && job.share <= 1) || !can_be_indexed<Shape>(job.from))
    return cudaErrorInvalidValue;
  constexpr unsigned threads = threads_to_arrange(Shape::fields);
  constexpr unsigned least_warps = 4; // of a block
  const auto there = static_cast<float>(blocks_at_once<arrange_kernel<Shape>, threads>());
  const unsigned most = std::max(1U, static_cast<unsigned>(there * job.share)),
                 wanted = (job.from.elements - 1) / (32 * least_warps) + 1;
  return launch_together<arrange_kernel<Shape>, threads>(std::min(wanted, most), stream, job,
                                                         tree_shape(job.from.elements));
}

} // namespace meetc::cuda

#endif
