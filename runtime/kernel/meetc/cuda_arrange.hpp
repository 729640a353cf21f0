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

// Of a block.
template <unsigned Threads, unsigned Fields> struct arrange_room {
  float rows[Threads / 32][32 * Fields];
  unsigned sums[Threads / 32];
  unsigned long long bad, crowded, longest;
  hilbert_cells cells;
  shared_steps steps;
};

// One block of those that arrange a set, whose threads all call its functions. Between two of these the blocks meet.
template <class Shape> class arranging {
public:
  static constexpr unsigned threads = threads_to_arrange(Shape::fields), fields = Shape::fields;
  using room = arrange_room<threads, fields>;

  __device__ arranging(const arrange_job &job, const tree_shape &shape, unsigned block, unsigned blocks, room &r)
      : job_(job), shape_(shape), room_(r), posed_(job.posed ? job.posed : job.from.data), n_(job.from.elements),
        block_(block), blocks_(blocks), step_(blocks * threads),
        // Warps that follow one another are in different blocks, so that few elements have many multiprocessors.
        first_((threadIdx.x / 32 * blocks + block) * 32) {}

  // Makes ready, and writes the rows unless they stand so already. Then its box is around all rows of the block.
  __device__ void start() {
    room_.steps.template fill<threads>();
    for (std::size_t i = block_ * threads + threadIdx.x; i < job_.clears; i += step_)
      job_.cleared[i] = 0;
    if (threadIdx.x == 0) {
      room_.bad = ~0ULL, room_.crowded = 0, room_.longest = 0;
      if (block_ == 0)
        *job_.found = {~0ULL, 0, 0};
    }
    __syncthreads();
    if (!job_.posed)
      return;
    tree_box mine; // empty
    for (std::uint32_t base = first_; base < n_;
         base += step_) { // a warp stays whole, since it writes its rows together
      if (base + lane_ < n_) {
        float row[fields];
        check_row(base + lane_, row);
        mine.widen(box_of_row<Shape>(row));
        for (unsigned f = 0; f < fields; ++f)
          of_warp()[lane_ * fields + f] = row[f];
      }
      write_rows<Shape::fields>(of_warp(), n_ - base, job_.posed + base * std::size_t{fields});
    }
    mine = around_block<threads>(mine);
    if (threadIdx.x == 0)
      job_.boxes[block_] = mine;
  }

  // Places, by a box around all rows that were written, or around some of those that stand already, and how many elements each
  // cell has.
  __device__ void count() {
    tree_box around; // empty
    if (job_.posed) {
      if (threadIdx.x < blocks_)
        around = job_.boxes[threadIdx.x];
    } else {
      const sample some(n_);
      for (std::uint32_t i = some.first + threadIdx.x * some.step; i < n_; i += threads * some.step)
        around.widen(box_of_row<Shape>(posed_ + i * std::size_t{fields}));
    }
    around = around_block<threads>(around);
    if (threadIdx.x == 0)
      room_.cells = hilbert_cells(around, job_.bits);
    __syncthreads();
    for (std::uint32_t i = first_ + lane_; i < n_; i += step_) {
      float row[fields];
      if (job_.posed)
        for (unsigned f = 0; f < fields; ++f)
          row[f] = posed_[i * std::size_t{fields} + f];
      else
        check_row(i, row);
      const std::uint32_t place = room_.cells.place_of(box_of_row<Shape>(row), room_.steps.table());
      job_.ranks[i] = in_order(place, atomicAdd(job_.cells + cell(in_order(place, i)), 1U));
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

  // Elements in their order. A warp copies the rows of its elements together.
  __device__ void put() {
    for (std::uint32_t base = first_; base < n_; base += step_) {
      std::uint32_t from = 0, to = n_; // n: there is none
      if (base + lane_ < n_) {
        const std::uint64_t element = job_.by_cell[base + lane_];
        const std::uint32_t of = cell(element), begin = job_.cells[of],
                            end = of + 1 < 1U << job_.cell_bits ? job_.cells[of + 1] : n_;
        from = static_cast<std::uint32_t>(element), to = base + lane_;
        if (end - begin > most_in_cell) { // each has a slot all the same
          atomicMax(&room_.longest, static_cast<unsigned long long>(end - begin));
        } else {
          const before_in_cell before(job_.by_cell, begin, end, element);
          if (before.alike >= tree_width)
            atomicAdd(&room_.crowded, 1ULL);
          to = begin + before.all;
        }
        job_.order[to] = number_in(job_.from, from);
      }
      for (unsigned k = lane_; k < 32 * fields; k += 32) {
        const std::uint32_t row_from = __shfl_sync(~0U, from, k / fields), row_to = __shfl_sync(~0U, to, k / fields);
        if (row_to < n_)
          job_.rows[row_to * std::size_t{fields} + k % fields] = posed_[row_from * std::size_t{fields} + k % fields];
      }
    }
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

  // Leaves what is counted with as it was, and makes the tree.
  __device__ void finish() {
    for (std::size_t c = block_ * threads + threadIdx.x; c < std::size_t{1} << job_.cell_bits; c += step_)
      job_.cells[c] = 0;
    sums().clear();
    if constexpr (can_arrange_tree(Shape::fields))
      if (job_.nodes)
        put_tree<Shape>(job_.rows, n_, job_.nodes, shape_, job_.arrived, block_, blocks_);
  }

private:
  __device__ void check_row(std::uint32_t i, float (&row)[fields]) {
    if (!posed_element<Shape>(job_.from, job_.at, i, row))
      atomicMin(&room_.bad, static_cast<unsigned long long>(number_in(job_.from, i)) << 32 | i);
  }
  __device__ std::uint32_t cell(std::uint64_t element) const { return cell_of(element, 3 * job_.bits, job_.cell_bits); }
  __device__ running_sums sums() const { return {job_.cells, 1U << job_.cell_bits, job_.totals, block_, blocks_}; }
  __device__ float *of_warp() const { return room_.rows[threadIdx.x / 32]; }

  const arrange_job &job_;
  const tree_shape &shape_;
  room &room_;
  const float *const posed_;
  const std::uint32_t n_;
  const unsigned block_, blocks_, step_, first_, lane_ = threadIdx.x % 32;
};

template <class Shape>
__global__ void __launch_bounds__(arranging<Shape>::threads, Shape::fields <= 4 ? 2 : 1)
    arrange_kernel(const __grid_constant__ arrange_jobs jobs) {
  __shared__ typename arranging<Shape>::room room;
  const bool second = blockIdx.x >= jobs.first_blocks;
  const unsigned before = second ? jobs.first_blocks : 0;
  arranging<Shape> mine(jobs.of[second], jobs.shape[second], blockIdx.x - before,
                        second ? gridDim.x - before : jobs.first_blocks, room);
  mine.start();
  if (jobs.of[0].posed || jobs.of[1].posed)
    meet_grid();
  mine.count();
  meet_grid();
  mine.sum();
  meet_grid();
  mine.scatter();
  meet_grid();
  mine.put();
  meet_grid();
  mine.finish();
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
