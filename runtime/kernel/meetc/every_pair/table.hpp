// The interface of the generated brute-force engine for a host: every pair of two sets, as a product of matrices.
//
// An element has an enclosing ball, and whether two balls may touch is one sign of a form with few products. The signs of all
// pairs are those of a product of matrices (matrix.hpp), which a filter takes on a matrix unit. The pairs that it leaves go
// through the steps that a query by the hierarchy has as well (meetc/cuda/table.hpp). No other launcher knows this engine.
//
// Every launcher enqueues its work on the stream; it allocates nothing, waits for nothing and throws nothing. All pointers are
// device memory unless said otherwise.
#ifndef MEETC_EVERY_PAIR_TABLE_HPP
#define MEETC_EVERY_PAIR_TABLE_HPP

#include <meetc/cuda/table.hpp>
#include <meetc/every_pair/matrix.hpp>

namespace meetc::every_pair {

// Who finds the pairs whose enclosing balls may touch.
enum class filter : std::uint8_t {
  float32, // the form in float32, which assumes nothing but IEEE arithmetic: the judge of the others
  mma,     // mma.sync, any device of capability 8.0 or more
  wgmma,   // wgmma, a device of capability 9.0 with code for sm_90a
};

// The findings of the probe.
struct probe_result {
  unsigned mma_faults, wgmma_faults; // cases in which the unit broke the model of matrix.hpp
  unsigned has_wgmma;                // the device runs code for sm_90a
  unsigned cases;                    // tried on each unit
};

// The columns of a set that a filter reads, as X or as Y.
struct operand {
  std::uint32_t elements;
  const void *columns; // half_bytes or float_bytes for each of matrix_padded(elements) elements
};
inline constexpr std::size_t half_bytes = std::size_t{2} * matrix_columns, float_bytes = 20;
constexpr std::size_t column_bytes(filter by, std::uint32_t elements) {
  return matrix_padded(elements) * (by == filter::float32 ? float_bytes : half_bytes);
}

// A part of the product begins at multiples of this many elements.
inline constexpr std::uint32_t part_step = 64;

// The lowest boxes of a set, as cuda::set_launchers::boxes makes them.
struct boxes_of_two {
  const cuda::tree_node *a, *b;
};

// The launchers for sets of one kind of element.
struct set_launchers {
  cuda::stated<const char *> name;
  // *around becomes what encloses the balls around the finite boxes of the elements.
  cuda::stated<cudaError_t (*)(const float *rows, std::uint32_t elements, extent *around, cudaStream_t stream)> enclose;
  // Writes the columns of all elements in the frame of *around, as X (first) or as Y. With balls around boxes, the filter
  // passes every pair whose boxes touch.
  cuda::stated<cudaError_t (*)(filter by, cover c, bool first, const float *rows, std::uint32_t elements,
                               const extent *around, void *columns, cudaStream_t stream)>
      columns;
};

struct catalogue {
  cuda::stated<const set_launchers *> kinds; // that of cuda::catalogue::kinds at each index
  cuda::stated<int> kind_count;
  // Appends the pairs of elements in the part whose enclosing balls may touch. Once the list is full it stops early; the count
  // is then some number above the capacity.
  cuda::stated<cudaError_t (*)(filter by, const operand &a, const operand &b, cuda::part of, cuda::pair_list out,
                               cudaStream_t stream)>
      candidates;
  // Appends to `out` the first min(*in.count, in.capacity) pairs whose boxes touch.
  cuda::stated<cudaError_t (*)(const boxes_of_two &boxes, cuda::pair_list in, cuda::pair_list out, cudaStream_t stream)>
      touching;
  // Tests the model of the matrix units.
  cuda::stated<cudaError_t (*)(probe_result *out, cudaStream_t stream)> probe;
};

// Plain rungs can say yes where nothing touches. With balls around boxes they decide the same pairs as a hierarchy.
constexpr cover balls_for(rung precision) {
  return never_wrong(precision) ? cover::element : cover::box;
}

// ---- a query in the caller's memory (query.hpp) ----

struct query_result {
  unsigned long long count; // the true number of touching pairs, even where it exceeds the capacity
  // Above list_capacity: the workspace is too small, count is too low, and the room that is needed is not known.
  unsigned long long near, candidates, kept;
  // As in cuda::order_findings. If an element is bad, the rest means nothing.
  unsigned long long bad_a, bad_b;
};
struct query {
  rung precision; // not tolerant, which presumes of the sets what nothing here looks at
  filter by;      // one that probe() did not refute
  cuda::view a;
  cuda::pose_matrix at_a;
  cuda::view b;
  cuda::pose_matrix at_b;
  index_pair *pairs; // in any order; null: only count
  unsigned long long capacity;
  query_result *result;
  void *workspace; // 256-byte aligned
  std::size_t bytes;
  unsigned long long list_capacity; // room for pairs between two stages
};

} // namespace meetc::every_pair

#endif
