// Sets' elements are put into their spatial order by one kernel. Included by nvcc only.
//
// Problem: of some hundred thousand elements a sort by digits is a chain of a dozen kernels, each of which waits more than it
// works. Method: one kernel whose blocks meet between its steps. An element's key is its place and its number; keys are put
// into order (distribute.hpp), a window of which at a time brings its rows to their places, where they make nodes of the
// tree. The order is that of a stable sort by places. Two sets of a query share the kernel, each with blocks of its own.
// Limits: up to most_to_arrange elements, not too many of them too close to each other.
#ifndef MEETC_CUDA_ARRANGE_HPP
#define MEETC_CUDA_ARRANGE_HPP

#include <meetc/cuda/distribute.hpp>
#include <meetc/cuda/grid.hpp>
#include <meetc/cuda/sets.hpp>
#include <meetc/cuda/tree.hpp>
#include <meetc/volume/tree_order.hpp>

namespace meetc::cuda {

// One set or two, the first of which has the first blocks.
struct arrange_jobs {
  arrange_job of[2];
  tree_shape shape[2];
  unsigned first_blocks;
};

// Nodes of level 1 whose elements are put at a time.
inline constexpr unsigned most_nodes_of_window = 4;

// The shared memory of a block.
template <unsigned Threads> struct arrange_room {
  distribute_room<Threads> keys;
  tree_box children[most_nodes_of_window][tree_width];
  hilbert_cells cells;
  shared_steps steps;
  unsigned long long bad;
  unsigned crowded, unordered;
};

// One block of those that arrange a set, whose threads all call its functions. Between two of these the blocks meet.
template <class Shape> class arranging {
public:
  static constexpr unsigned threads = threads_to_arrange(Shape::fields), fields = Shape::fields;
  using room = arrange_room<threads>;

  __device__ arranging(const arrange_job &job, const tree_shape &shape, unsigned block, unsigned blocks, room &r)
      : job_(job), shape_(shape), room_(r), posed_(job.posed ? job.posed : job.from.data), n_(job.from.elements),
        block_(block), blocks_(blocks),
        keys_(job.keys, 32 + 3 * bits_to_arrange, job.from.index || job.from.only, block, blocks, r.keys) {}

  // Whether all rows are written before their places are known, which are by a box around these.
  MEETC_HD static bool poses_first(const arrange_job &job) { return job.posed && !job.common; }

  // Makes ready, and writes the rows if that comes first. Then its box is around all rows of the block.
  __device__ void start() {
    take_samples();
    const unsigned step = blocks_ * threads;
    for (std::size_t i = block_ * threads + threadIdx.x; i < job_.clears; i += step)
      job_.cleared[i] = 0;
    if (threadIdx.x == 0) {
      room_.bad = ~0ULL, room_.crowded = 0, room_.unordered = 0;
      if (block_ == 0)
        *job_.found = {~0ULL, 0, 0};
    }
    __syncthreads();
    if (!poses_first(job_))
      return;
    tree_box mine; // empty
    for (std::uint32_t i = block_ * threads + threadIdx.x; i - lane_ < n_; i += step)
      pose_warp(i, i < n_, [&](const float *row) { mine.widen(box_of_row<Shape>(row)); });
    mine = around_block<threads>(mine);
    if (threadIdx.x == 0)
      job_.boxes[block_] = mine;
  }

  // Places. They are by the box that is known, or around all rows that were written, or around some of those that stand
  // already.
  __device__ void count() {
    if (job_.common)
      around_ = common_box(job_.common[0], job_.common[1]);
    else if (job_.posed && threadIdx.x < blocks_)
      around_ = job_.boxes[threadIdx.x];
    if (!job_.common)
      around_ = around_block<threads>(around_);
    if (threadIdx.x == 0)
      room_.cells = hilbert_cells(around_, bits_to_arrange);
    __syncthreads();
    hilbert_cells cells = room_.cells;
    cells.bits = bits_to_arrange; // which is known here
    const auto key_of = [&](const float *row, std::uint32_t i) {
      return in_order(cells.place_of(box_of_row<Shape>(row), room_.steps.table()), i);
    };
    if (job_.posed && job_.common) {
      keys_.template count<1>([&](const std::uint32_t(&i)[1], const bool(&there)[1], std::uint64_t(&key)[1]) {
        pose_warp(i[0], there[0], [&](const float *row) { key[0] = key_of(row, i[0]); });
      });
      return;
    }
    constexpr unsigned together = fields <= 6 ? 2 : 1; // whose rows are on their way at once
    const view rows{posed_, fields * sizeof(float), nullptr, 0, n_};
    keys_.template count<together>(
        [&](const std::uint32_t(&i)[together], const bool(&there)[together], std::uint64_t(&key)[together]) {
          float of[together][fields];
#pragma unroll
          for (unsigned k = 0; k < together; ++k)
            if (there[k])
              read_element<Shape>(rows, i[k], of[k]);
#pragma unroll
          for (unsigned k = 0; k < together; ++k)
            if (there[k]) {
              if (!job_.posed && !is_good<Shape>(of[k]))
                note_bad(i[k]);
              key[k] = key_of(of[k], i[k]);
            }
        });
  }

  __device__ void distribute() {
    keys_.distribute();
  }

  // Elements in their places, and the tree.
  __device__ void put() {
    keys_.clear();
    choose_window();
    const bool tree = has_tree && job_.nodes;
    const std::uint32_t end = !tree ? n_ : (shape_.depth == 4 ? nodes_above(shape_, 1) : shape_.count[1]) * of_node;
    for (std::uint32_t first = block_ * window_; first < end; first += blocks_ * window_)
      put_window(first, take_window(first));
    note_found();
    if constexpr (has_tree)
      if (tree && shape_.depth >= 3)
        put_root(job_.nodes, shape_, blocks_, job_.arrived);
  }

private:
  // The elements of a node of level 1; those before a window tell which of its own are crowded.
  static constexpr unsigned of_node = tree_width * tree_width, before_window = tree_width;
  static constexpr bool has_tree = can_arrange_tree(Shape::fields);

  // As many elements as a block has work: some nodes of level 1, or, where these are all below the root, a part of one.
  __device__ void choose_window() {
    constexpr std::uint32_t least = 256;
    const std::uint32_t wanted = (n_ - 1) / blocks_ + 1;
    window_ = min(most_nodes_of_window, (wanted - 1) / of_node + 1) * of_node;
    while (shape_.depth < 4 && window_ > least && window_ / 2 >= wanted)
      window_ /= 2;
  }

  // Samples rows that stand already, and takes the steps of places while the rows are on their way.
  __device__ void take_samples() {
    const sample some(n_);
    const bool samples = !job_.posed && !job_.common;
    std::uint32_t i = some.first + threadIdx.x * some.step;
    float row[fields];
    const bool mine = samples && i < n_;
    if (mine)
      for (unsigned f = 0; f < fields; ++f)
        row[f] = posed_[i * std::size_t{fields} + f];
    room_.steps.template fill<threads>();
    if (mine)
      around_.widen(box_of_row<Shape>(row));
    for (i += threads * some.step; samples && i < n_; i += threads * some.step)
      around_.widen(box_of_row<Shape>(posed_ + i * std::size_t{fields}));
  }

  // A warp, which writes together, poses its rows, of which lane 0 has the first. A lane that has one calls take(row).
  template <class Take> __device__ void pose_warp(std::uint32_t i, bool there, Take &&take) {
    float *const rows_here = rows_of_warp(0);
    if (there) {
      float row[fields];
      if (!posed_element<Shape>(job_.from, job_.at, i, row))
        note_bad(i);
      take(row);
      for (unsigned f = 0; f < fields; ++f)
        rows_here[lane_ * fields + f] = row[f];
    }
    const unsigned rows = __popc(__ballot_sync(~0U, there));
    if (rows > 0)
      write_rows<Shape::fields>(rows_here, rows, job_.posed + (i - lane_) * std::size_t{fields});
  }

  // Keys of a window, and of some before it; false where there are none. Keys without an order stay as they are, so that each
  // element has a place all the same.
  __device__ bool take_window(std::uint32_t first) {
    if (first >= n_)
      return false;
    const std::uint32_t from = first - min(first, before_window), end = min(n_ - first, window_) + first;
    if (!keys_.window(from, end)) {
      if (threadIdx.x == 0)
        room_.unordered = 1;
#pragma unroll 1
      for (std::uint32_t i = from + threadIdx.x; i < end; i += threads)
        room_.keys.keys[i - from] = job_.keys.by_cell[i];
    }
    return true;
  }
  // A warp brings the rows of some neighbours to their places, and makes nodes of level 0 of them. Rows of four numbers are on
  // their way at once.
  __device__ void put_window(std::uint32_t first, bool there) {
    __syncthreads(); // of an earlier window nobody reads any more
    const unsigned of_warp = threadIdx.x / 32 * 32;
    if (fields == 4 && reinterpret_cast<std::uintptr_t>(posed_) % sizeof(float4) == 0) {
      static_assert(fields != 4 || most_nodes_of_window * of_node == 4 * threads);
      std::uint32_t from[4];
      float4 rows[4];
#pragma unroll
      for (unsigned k = 0; k < 4; ++k)
        if (const unsigned at = of_warp + k * threads; there && at < window_) {
          from[k] = take_key(first, at);
          if (first + at + lane_ < n_)
            rows[k] = reinterpret_cast<const float4 *>(posed_)[from[k]];
        }
#pragma unroll
      for (unsigned k = 0; k < 4; ++k)
        if (const unsigned at = of_warp + k * threads; at < window_) {
          tree_box b;
          if (const std::uint32_t i = first + at + lane_; there && i < n_) {
            reinterpret_cast<float4 *>(job_.rows)[i] = rows[k];
            const float row[4] = {rows[k].x, rows[k].y, rows[k].z, rows[k].w};
            b = box_of_row<Shape>(row);
          }
          put_node(first, at, b);
        }
    } else {
      for (unsigned at = of_warp; at < window_; at += threads) {
        tree_box b;
        if (const std::uint32_t base = first + at; there && base < n_) {
          const std::uint32_t from = take_key(first, at);
          float *const rows = rows_of_warp(most_nodes_of_window * of_node + before_window);
          bring_rows<fields>(posed_, from, min(n_ - base, 32U), rows, job_.rows + base * std::size_t{fields});
          if (base + lane_ < n_)
            b = box_of_row<Shape>(rows + lane_ * fields);
          __syncwarp();
        }
        put_node(first, at, b);
      }
    }
    if constexpr (has_tree) {
      __syncthreads();
      const unsigned which = threadIdx.x / 32, node = first / of_node + which;
      if (job_.nodes && shape_.depth == 4 && which * of_node < window_ && node < nodes_above(shape_, 1))
        put_around(job_.nodes, shape_, 1, node, room_.children[which]);
    }
  }
  // The number, in the caller's order or in `posed`, of the element that belongs to this lane's place of the window.
  __device__ std::uint32_t take_key(std::uint32_t first, unsigned at) {
    const std::uint32_t place = first + at + lane_, of_key = min(first, before_window) + at + lane_;
    const bool there = place < n_;
    const std::uint64_t key = there ? room_.keys.keys[of_key] : 0;
    const unsigned crowded = __popc(__ballot_sync(~0U, there && place >= before_window &&
                                                           key >> 32 == room_.keys.keys[of_key - before_window] >> 32));
    if (lane_ == 0 && crowded > 0)
      atomicAdd(&room_.crowded, crowded);
    const auto from = static_cast<std::uint32_t>(key);
    if (there)
      job_.order[place] = number_in(job_.from, from);
    return from;
  }
  __device__ void put_node(std::uint32_t first, unsigned at, const tree_box &b) {
    if constexpr (has_tree)
      if (job_.nodes) {
        const unsigned node = (first + at) / tree_width;
        put_child(job_.nodes, shape_, 1, node / tree_width, node % tree_width, put_leaf(job_.nodes, shape_, node, b),
                  room_.children[at / of_node]);
      }
  }

  __device__ void note_bad(std::uint32_t i) {
    atomicMin(&room_.bad, static_cast<unsigned long long>(number_in(job_.from, i)) << 32 | i);
  }
  __device__ void note_found() {
    __syncthreads();
    if (threadIdx.x != 0)
      return;
    if (room_.bad != ~0ULL)
      atomicMin(&job_.found->bad, room_.bad);
    if (room_.crowded > 0)
      atomicAdd(&job_.found->crowded, static_cast<unsigned long long>(room_.crowded));
    if (room_.unordered > 0)
      atomicMax(&job_.found->unordered, static_cast<unsigned long long>(room_.unordered));
  }
  // Rows of a warp, behind so many keys: before keys are there none, and afterwards also where cells of windows are counted.
  __device__ float *rows_of_warp(unsigned keys) const {
    constexpr std::size_t bytes = threads * fields * sizeof(float);
    static_assert(sizeof room_.keys.keys >= bytes);
    static_assert(sizeof room_.keys.keys + sizeof room_.keys.counters >=
                  (most_nodes_of_window * of_node + before_window) * sizeof(std::uint64_t) + bytes);
    return reinterpret_cast<float *>(room_.keys.keys + keys) + threadIdx.x / 32 * (32 * fields);
  }

  const arrange_job &job_;
  const tree_shape &shape_;
  room &room_;
  const float *const posed_;
  const std::uint32_t n_;
  const unsigned block_, blocks_, lane_ = threadIdx.x % 32;
  distributing<threads> keys_;
  tree_box around_; // what this thread knows of that
  std::uint32_t window_ = 0;
};

template <class Shape>
__global__ void __launch_bounds__(arranging<Shape>::threads, 1)
    arrange_kernel(const __grid_constant__ arrange_jobs jobs) {
  auto &room = *reinterpret_cast<typename arranging<Shape>::room *>(shared_memory());
  const bool second = blockIdx.x >= jobs.first_blocks;
  const unsigned before = second ? jobs.first_blocks : 0;
  arranging<Shape> mine(jobs.of[second], jobs.shape[second], blockIdx.x - before,
                        second ? gridDim.x - before : jobs.first_blocks, room);
  mine.start();
  if (mine.poses_first(jobs.of[0]) || mine.poses_first(jobs.of[1]))
    meet_grid();
  mine.count();
  meet_grid();
  mine.distribute();
  meet_grid();
  mine.put();
}

template <class Shape> cudaError_t arrange(const arrange_job *jobs, int count, cudaStream_t stream) {
  constexpr unsigned threads = arranging<Shape>::threads, least_warps = 4; // of a block
  constexpr std::size_t bytes = sizeof(typename arranging<Shape>::room);
  static_assert(threads <= most_blocks_to_arrange && bytes <= least_shared_memory);
  const unsigned there = std::min(blocks_at_once<arrange_kernel<Shape>, threads, bytes>(), threads);
  arrange_jobs all{};
  unsigned blocks[2] = {0, 0};
  if (count < 1 || count > 2)
    return cudaErrorInvalidValue;
  for (int k = 0; k < count; ++k) {
    const arrange_job &job = jobs[k];
    if (job.from.elements == 0 || job.from.elements > most_to_arrange || job.keys.n != job.from.elements ||
        !(job.share > 0 && job.share <= 1) || !can_be_indexed<Shape>(job.from))
      return cudaErrorInvalidValue;
    const unsigned most = std::max(1U, static_cast<unsigned>(static_cast<float>(there) * job.share)),
                   wanted = (job.from.elements - 1) / (32 * least_warps) + 1;
    all.of[k] = job, all.shape[k] = tree_shape(job.from.elements), blocks[k] = std::min(wanted, most);
  }
  all.first_blocks = blocks[0];
  if (blocks[0] + blocks[1] > there)
    return cudaErrorCooperativeLaunchTooLarge;
  return launch_together<arrange_kernel<Shape>, threads, bytes>(blocks[0] + blocks[1], stream, all);
}

} // namespace meetc::cuda

#endif
