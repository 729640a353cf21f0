// Sets' elements are put into their spatial order by one kernel. Included by nvcc only.
//
// Problem: of some hundred thousand elements a sort by digits is a chain of a dozen kernels, each of which waits more than it
// works. Method: one kernel whose blocks meet between its steps. Elements are counted by the first bits of their places, whose
// cells are as many as they are; sums of the counts say where each cell begins; and an element's rank within its cell, where
// few others are, is the number of those that come before it. The order is that of a stable sort by places. Two sets of a query
// share the kernel, each with blocks of its own.
// Limits: up to most_to_arrange elements, and no more than most_in_cell in a cell.
#ifndef MEETC_CUDA_ARRANGE_HPP
#define MEETC_CUDA_ARRANGE_HPP

#include <meetc/cuda_grid.hpp>
#include <meetc/cuda_sets.hpp>
#include <meetc/cuda_tree.hpp>
#include <meetc/tree_order.hpp>

namespace meetc::cuda {

// One set or two, the first of which has the first blocks.
struct arrange_jobs {
  arrange_job of[2];
  tree_shape shape[2];
  unsigned first_blocks;
};

// Of a block. Elements are no longer looked at when rows are.
template <unsigned Threads, unsigned Fields> struct arrange_room {
  union {
    alignas(16) float rows[Threads / 32][32 * Fields];
    std::uint64_t elements[Threads];
  };
  std::uint32_t slots[Threads];
  unsigned sums[Threads / 32];
  unsigned long long bad, crowded, longest;
  std::uint32_t begin, end; // of the cells that reach into a tile
  hilbert_cells cells;
  shared_steps steps;
};

// One block of those that arrange a set, whose threads all call its functions. Between two of these the blocks meet.
template <class Shape> class arranging {
public:
  static constexpr unsigned threads = threads_to_arrange(Shape::fields), fields = Shape::fields;
  using room = arrange_room<threads, fields>;

  __device__ arranging(const arrange_job &job, const tree_shape &shape, unsigned block, unsigned blocks, room &r)
      : job_(job), shape_(shape), room_(r), n_(job.from.elements), block_(block), blocks_(blocks),
        step_(blocks * threads),
        // Warps that follow one another are in different blocks, so that few elements have many multiprocessors.
        first_((threadIdx.x / 32 * blocks + block) * 32) {}

  // Places, and how many elements each cell has.
  __device__ void count() {
    start();
    for (std::uint32_t base = first_; base < n_;
         base += step_) { // a warp stays whole, since it writes its rows together
      const std::uint32_t i = base + lane_;
      if (i < n_) {
        float row[fields];
        if (!posed_element<Shape>(job_.from, job_.at, i, row))
          atomicMin(&room_.bad, static_cast<unsigned long long>(number_in(job_.from, i)) << 32 | i);
        const std::uint32_t place = room_.cells.place_of(box_of_row<Shape>(row), room_.steps.table());
        job_.ranks[i] = in_order(place, atomicAdd(job_.cells + cell(in_order(place, i)), 1U));
        for (unsigned f = 0; job_.posed && f < fields; ++f)
          of_warp()[lane_ * fields + f] = row[f];
      }
      if (job_.posed)
        write_rows<Shape::fields>(of_warp(), n_ - base, job_.posed + base * std::size_t{fields});
    }
  }

  // Where each cell begins.
  __device__ void sum() { sums().template sum<threads>(room_.sums); }

  // Elements by their cells.
  __device__ void scatter() {
    for (std::uint32_t i = first_ + lane_; i < n_; i += step_) {
      const std::uint64_t ranked = job_.ranks[i], element = in_order(static_cast<std::uint32_t>(ranked >> 32), i);
      job_.by_cell[job_.cells[cell(element)] + static_cast<std::uint32_t>(ranked)] = element;
    }
  }

  // Elements in their order, and the tree. A block takes as many slots at once as it has threads, which are a node of level 1.
  __device__ void put() {
    for (std::size_t c = block_ * threads + threadIdx.x; c < std::size_t{1} << job_.cell_bits; c += step_)
      job_.cells[c] = 0;
    sums().clear();
    const bool tree = can_arrange_tree(Shape::fields) && job_.nodes;
    const unsigned tiles = tree ? nodes_above(shape_, 1) : (n_ - 1) / threads + 1;
    for (unsigned tile = block_; tile < tiles; tile += blocks_) {
      const std::uint32_t first = tile * threads;
      if (first < n_)
        find_slots(first);
      tree_box b;
      if (const std::uint32_t base = first + threadIdx.x - lane_; base < n_)
        b = bring(base);
      if constexpr (can_arrange_tree(Shape::fields))
        if (tree)
          put_above(job_.nodes, shape_, 1, tile,
                    put_leaf(job_.nodes, shape_, tile * tree_width + threadIdx.x / tree_width, b));
    }
    if (tree && shape_.depth == 4)
      put_root(job_.nodes, shape_, blocks_, job_.arrived);
    __syncthreads();
    if (threadIdx.x == 0) {
      if (room_.bad != ~0ULL)
        atomicMin(&job_.found->bad, room_.bad);
      if (room_.crowded > 0)
        atomicAdd(&job_.found->crowded, room_.crowded);
      if (room_.longest > 0)
        atomicMax(&job_.found->longest, room_.longest);
    }
  }

private:
  // Every block finds the same box by which elements get places.
  __device__ void start() {
    room_.steps.template fill<threads>();
    for (std::size_t i = block_ * threads + threadIdx.x; i < job_.clears; i += step_)
      job_.cleared[i] = 0;
    tree_box mine; // empty
    const sample some(n_);
    for (std::uint32_t i = some.first + threadIdx.x * some.step; i < n_; i += threads * some.step) {
      float row[fields];
      posed_element<Shape>(job_.from, job_.at, i, row);
      mine.widen(box_of_row<Shape>(row));
    }
    const tree_box around = around_block<threads>(mine);
    if (threadIdx.x == 0) {
      room_.cells = hilbert_cells(around, job_.bits);
      room_.bad = ~0ULL, room_.crowded = 0, room_.longest = 0;
      if (block_ == 0)
        *job_.found = {~0ULL, 0, 0};
    }
    __syncthreads();
  }

  // Which elements belong to the slots from this one on, a thread each.
  __device__ void find_slots(std::uint32_t first) {
    const std::uint32_t end = n_ - first < threads ? n_ : first + threads, k = first + threadIdx.x;
    __syncthreads(); // of the slots before nobody reads any more
    if (k < end)
      room_.elements[threadIdx.x] = job_.by_cell[k];
    if (threadIdx.x == 0)
      room_.begin = first, room_.end = end;
    __syncthreads();
    const auto element = [&](std::uint32_t i) {
      return i - first < end - first ? room_.elements[i - first] : job_.by_cell[i];
    };
    const auto place = [&](std::uint32_t i) {
      const place_in_order of(
          element, [&](std::uint64_t e) { return cell(e); }, n_, i, most_in_cell);
      if (of.slot - first < end - first)
        room_.slots[of.slot - first] = static_cast<std::uint32_t>(element(i));
      return of;
    };
    if (k < end) {
      const place_in_order mine = place(k);
      if (mine.end - mine.begin > most_in_cell) {
        atomicMax(&room_.longest, static_cast<unsigned long long>(mine.end - mine.begin));
      } else {
        if (mine.crowded)
          atomicAdd(&room_.crowded, 1ULL);
        if (k == first)
          room_.begin = mine.begin;
        if (k == end - 1)
          room_.end = mine.end;
      }
    }
    __syncthreads();
    // Of a cell that reaches out of these slots, any element may belong here.
    for (std::uint32_t i = room_.begin + threadIdx.x; i < first; i += threads)
      place(i);
    for (std::uint32_t i = end + threadIdx.x; i < room_.end; i += threads)
      place(i);
    __syncthreads();
  }

  // A warp brings the rows of its slots, from this one on. Returns the box of this lane's.
  __device__ tree_box bring(std::uint32_t base) {
    const std::uint32_t slot = base + lane_, from = slot < n_ ? room_.slots[threadIdx.x] : 0;
    if (slot < n_)
      job_.order[slot] = number_in(job_.from, from);
    bring_rows<fields>(job_.posed ? job_.posed : job_.from.data, from, n_ - base < 32 ? n_ - base : 32, of_warp(),
                       job_.rows + base * std::size_t{fields});
    tree_box b;
    if (slot < n_)
      b = box_of_row<Shape>(of_warp() + lane_ * fields);
    return b;
  }

  __device__ std::uint32_t cell(std::uint64_t element) const { return cell_of(element, 3 * job_.bits, job_.cell_bits); }
  __device__ running_sums sums() const { return {job_.cells, 1U << job_.cell_bits, job_.totals, block_, blocks_}; }
  __device__ float *of_warp() const { return room_.rows[threadIdx.x / 32]; }

  const arrange_job &job_;
  const tree_shape &shape_;
  room &room_;
  const std::uint32_t n_;
  const unsigned block_, blocks_, step_, first_, lane_ = threadIdx.x % 32;
};

template <class Shape>
__global__ void __launch_bounds__(arranging<Shape>::threads) arrange_kernel(const __grid_constant__ arrange_jobs jobs) {
  __shared__ typename arranging<Shape>::room room;
  const bool second = blockIdx.x >= jobs.first_blocks;
  const unsigned before = second ? jobs.first_blocks : 0;
  arranging<Shape> mine(jobs.of[second], jobs.shape[second], blockIdx.x - before,
                        second ? gridDim.x - before : jobs.first_blocks, room);
  mine.count();
  meet_grid();
  mine.sum();
  meet_grid();
  mine.scatter();
  meet_grid();
  mine.put();
}

template <class Shape> cudaError_t arrange(const arrange_job *jobs, int count, cudaStream_t stream) {
  constexpr unsigned threads = arranging<Shape>::threads;
  constexpr unsigned least_warps = 4; // of a block
  static_assert(threads <= most_blocks_to_arrange);
  const unsigned there = std::min(blocks_at_once<arrange_kernel<Shape>, threads>(), threads);
  arrange_jobs all{};
  unsigned blocks[2] = {0, 0};
  if (count < 1 || count > 2)
    return cudaErrorInvalidValue;
  for (int k = 0; k < count; ++k) {
    const arrange_job &job = jobs[k];
    if (job.from.elements == 0 || job.from.elements > most_to_arrange || job.cell_bits > 3 * job.bits ||
        !(job.share > 0 && job.share <= 1) || !can_be_indexed<Shape>(job.from))
      return cudaErrorInvalidValue;
    const unsigned most = std::max(1U, static_cast<unsigned>(static_cast<float>(there) * job.share)),
                   wanted = (job.from.elements - 1) / (32 * least_warps) + 1;
    all.of[k] = job, all.shape[k] = tree_shape(job.from.elements), blocks[k] = std::min(wanted, most);
  }
  all.first_blocks = blocks[0];
  if (blocks[0] + blocks[1] > there)
    return cudaErrorCooperativeLaunchTooLarge;
  return launch_together<arrange_kernel<Shape>, threads>(blocks[0] + blocks[1], stream, all);
}

} // namespace meetc::cuda

#endif
