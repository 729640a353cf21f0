// The spatial order and the lowest boxes of a set on the device, which depend on the kind of element. Included by nvcc only.
#ifndef MEETC_CUDA_TREE_HPP
#define MEETC_CUDA_TREE_HPP

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/sets.hpp>
#include <meetc/cuda/table.hpp>
#include <meetc/cuda/warp.hpp>
#include <meetc/volume/tree_order.hpp>

namespace meetc::cuda {

inline constexpr unsigned tree_threads = 128, node_threads = tree_width * tree_width;

static __device__ const hilbert_steps all_hilbert_steps;
// A copy in shared memory, where lanes read different entries at once.
struct shared_steps {
  static constexpr unsigned words = sizeof(hilbert_steps) / sizeof(std::uint32_t);
  std::uint32_t of[words];

  template <unsigned Threads> __device__ void fill() {
    for (unsigned i = threadIdx.x; i < words; i += Threads)
      of[i] = reinterpret_cast<const std::uint32_t *>(&all_hilbert_steps)[i];
  }
  __device__ const hilbert_steps &table() const { return *reinterpret_cast<const hilbert_steps *>(of); }
};

template <class Shape>
__global__ void __launch_bounds__(tree_threads)
    places_kernel(const float *rows, unsigned n, const joined_box *around, int bits, std::uint32_t *places,
                  std::uint32_t *numbers, unsigned long long *bad) {
  begin();
  __shared__ hilbert_cells cells;
  __shared__ shared_steps steps;
  if (threadIdx.x == 0)
    cells = hilbert_cells(box_of(*around), bits);
  steps.fill<tree_threads>();
  __syncthreads();
  const view packed{rows, Shape::fields * sizeof(float), nullptr, 0, n};
  for (std::size_t i = blockIdx.x * std::size_t{tree_threads} + threadIdx.x; i < n;
       i += gridDim.x * std::size_t{tree_threads}) {
    float row[Shape::fields];
    const bool there = read_element<Shape>(packed, static_cast<std::uint32_t>(i), row);
    if (bad && !(is_good<Shape>(row) && there))
      atomicMin(bad, static_cast<unsigned long long>(i) << 32 | i);
    places[i] = cells.place_of(box_of_row<Shape>(row), steps.table());
    numbers[i] = static_cast<std::uint32_t>(i);
  }
}
template <class Shape>
cudaError_t places(const float *rows, std::uint32_t n, const joined_box *around, int bits, std::uint32_t *places,
                   std::uint32_t *numbers, unsigned long long *bad, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const unsigned blocks = std::min((n - 1) / tree_threads + 1, blocks_at_once<places_kernel<Shape>, tree_threads>());
  return launch<places_kernel<Shape>>(blocks, tree_threads, stream, rows, n, around, bits, places, numbers, bad);
}

// A warp makes a node of level 0, to which each lane brings a box, and returns the box around it.
__device__ inline tree_box put_leaf(tree_node *nodes, const tree_shape &shape, std::uint32_t node, const tree_box &b) {
  if (node < shape.count[0])
    put_box(nodes[node], threadIdx.x % tree_width, b);
  return around_warp(b);
}

// A warp brings the first rows, of which each lane names one, up to 32, to where they belong, one after another, and to its
// shared memory `of_warp`, which rows of four have aligned.
template <unsigned Fields>
__device__ void bring_rows(const float *rows, std::uint32_t from, unsigned here, float *of_warp, float *to) {
  const unsigned lane = threadIdx.x % 32;
  const auto in_fours = [](const float *p) { return reinterpret_cast<std::uintptr_t>(p) % 16 == 0; };
  if (Fields == 4 && in_fours(rows) && in_fours(to)) {
    if (lane < here) {
      const float4 row = reinterpret_cast<const float4 *>(rows)[from];
      reinterpret_cast<float4 *>(of_warp)[lane] = row;
      reinterpret_cast<float4 *>(to)[lane] = row;
    }
  } else {
    for (unsigned first = 0; first < here * Fields; first += 32) {
      const unsigned k = first + lane, row = k / Fields;
      const std::uint32_t of = __shfl_sync(~0U, from, row % 32);
      if (k < here * Fields) {
        const float x = rows[std::size_t{of} * Fields + (k - row * Fields)];
        of_warp[k] = x, to[k] = x;
      }
    }
  }
  __syncwarp();
}

// A warp takes the rows of a node of level 0, and brings them to their places in one piece.
template <class Shape>
__global__ void __launch_bounds__(tree_threads)
    gather_kernel(const __grid_constant__ gather_job job, const __grid_constant__ tree_shape shape) {
  begin();
  constexpr unsigned fields = Shape::fields, width = tree_width;
  alignas(16) __shared__ float rows_of_warps[tree_threads / width][width * fields]; // rows of four are written as such
  float *const of_warp = rows_of_warps[threadIdx.x / width];
  const unsigned lane = threadIdx.x % width, n = job.elements;
  const std::uint32_t node = static_cast<std::uint32_t>((blockIdx.x * std::size_t{tree_threads} + threadIdx.x) / width);
  const std::size_t base = std::size_t{node} * width, at = base + lane;
  const bool there = at < n;
  const std::uint32_t from = there ? job.slots[at] : 0;
  const unsigned crowded =
      __ballot_sync(~0U, there && at >= width && job.sorted[at] == job.sorted[at >= width ? at - width : 0]);
  if (lane == 0 && crowded != 0)
    atomicAdd(job.crowded, static_cast<unsigned long long>(__popc(crowded)));
  if (there && job.names)
    job.slots[at] = job.names[from];
  if (base < n)
    bring_rows<fields>(job.from, from, n - base < width ? static_cast<unsigned>(n - base) : width, of_warp,
                       job.rows + base * fields);
  if (!job.nodes)
    return;
  tree_box b;
  if (there)
    b = box_of_row<Shape>(of_warp + lane * fields);
  b = put_leaf(job.nodes, shape, node, b);
  if (lane == 0)
    put_box(job.nodes[shape.first[1] + node / width], node % width, b);
}
template <class Shape> cudaError_t gather(const gather_job &job, cudaStream_t stream) {
  if (job.elements == 0)
    return cudaSuccess;
  const tree_shape shape(job.elements);
  return launch<gather_kernel<Shape>>(shape.count[1] * (node_threads / tree_threads), tree_threads, stream, job, shape);
}

// A warp brings the box around child `which` of a node of `level` there, and to the node's children in shared memory. Empty
// lanes of nodes are written too.
__device__ inline void put_child(tree_node *nodes, const tree_shape &shape, int level, unsigned node, unsigned which,
                                 const tree_box &child, tree_box *children) {
  if (threadIdx.x % tree_width != 0)
    return;
  if (node < shape.count[level])
    put_box(nodes[shape.first[level] + node], which, child);
  children[which] = child;
}
// A warp brings the box around all children of a node to the level above, if there is one.
__device__ inline void put_around(tree_node *nodes, const tree_shape &shape, int level, unsigned node,
                                  const tree_box *children) {
  if (level + 1 == shape.depth)
    return;
  const tree_box all = around_warp(children[threadIdx.x % tree_width]);
  if (threadIdx.x % tree_width == 0)
    put_box(nodes[shape.first[level + 1] + node / tree_width], node % tree_width, all);
}
// A block has a warp for each child of a node. All of its threads call it.
__device__ inline void put_above(tree_node *nodes, const tree_shape &shape, int level, unsigned node,
                                 const tree_box &child) {
  __shared__ tree_box children[tree_width];
  const unsigned warp = threadIdx.x / tree_width;
  __syncthreads(); // of an earlier call nobody reads any more
  put_child(nodes, shape, level, node, warp, child, children);
  __syncthreads();
  if (warp == 0)
    put_around(nodes, shape, level, node, children);
}
// As many nodes as that takes.
MEETC_HD inline unsigned nodes_above(const tree_shape &shape, int level) {
  return level + 1 == shape.depth ? shape.count[level] : shape.count[level + 1] * tree_width;
}

// A warp of the block that comes last, of so many, makes the box of a node of the level below the root, and brings it there. A
// block has written what it knows of that level.
__device__ inline void put_root(tree_node *nodes, const tree_shape &shape, unsigned blocks, unsigned *arrived) {
  __shared__ bool is_last;
  __syncthreads();
  if (threadIdx.x == 0) {
    __threadfence();
    is_last = atomicInc(arrived, blocks - 1) == blocks - 1;
    __threadfence();
  }
  __syncthreads();
  if (!is_last)
    return;
  const unsigned node = threadIdx.x / tree_width, lane = threadIdx.x % tree_width;
  const int below = shape.depth - 2;
  const tree_box all =
      around_warp(node < shape.count[below] ? box_of(nodes[shape.first[below] + node], lane) : tree_box());
  if (lane == 0)
    put_box(nodes[shape.first[below + 1]], node, all);
}

// A warp makes a node of level 0 of rows, and returns the box around it.
template <class Shape>
__device__ tree_box put_elements(const float *rows, unsigned n, tree_node *nodes, const tree_shape &shape,
                                 unsigned node) {
  const std::size_t at = std::size_t{node} * tree_width + threadIdx.x % tree_width;
  tree_box b;
  if (at < n)
    b = box_of_row<Shape>(rows + at * std::size_t{Shape::fields});
  return put_leaf(nodes, shape, node, b);
}

template <class Shape>
__global__ void __launch_bounds__(node_threads)
    small_tree_kernel(const float *rows, unsigned n, tree_node *nodes, const __grid_constant__ tree_shape shape,
                      unsigned *arrived) {
  begin();
  const unsigned all = nodes_above(shape, 1);
  for (unsigned node = blockIdx.x; node < all; node += gridDim.x)
    put_above(nodes, shape, 1, node,
              put_elements<Shape>(rows, n, nodes, shape, node * tree_width + threadIdx.x / tree_width));
  if (shape.depth == 4)
    put_root(nodes, shape, gridDim.x, arrived);
}
// A warp makes a node of level 0, and its box in level 1.
template <class Shape>
__global__ void __launch_bounds__(tree_threads)
    boxes_kernel(const float *rows, unsigned n, tree_node *nodes, const __grid_constant__ tree_shape shape) {
  begin();
  const unsigned node = (blockIdx.x * tree_threads + threadIdx.x) / tree_width;
  const tree_box b = put_elements<Shape>(rows, n, nodes, shape, node);
  if (threadIdx.x % tree_width == 0)
    put_box(nodes[shape.first[1] + node / tree_width], node % tree_width, b);
}
template <class Shape>
cudaError_t boxes(const float *rows, std::uint32_t n, tree_node *nodes, unsigned *arrived, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const tree_shape shape(n);
  if (levels_with_boxes(n) >= shape.depth)
    return launch<small_tree_kernel<Shape>>(nodes_above(shape, 1), node_threads, stream, rows, n, nodes, shape,
                                            arrived);
  return launch<boxes_kernel<Shape>>(shape.count[1] * (node_threads / tree_threads), tree_threads, stream, rows, n,
                                     nodes, shape);
}

} // namespace meetc::cuda

#endif
