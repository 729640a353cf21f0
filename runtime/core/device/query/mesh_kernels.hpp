// core/device/query/mesh_kernels.hpp: the kernels of a mesh with itself. They know elements with three corners and nothing else
// of them, and only enqueue work.
#ifndef MEETC_CORE_DEVICE_QUERY_MESH_KERNELS_HPP
#define MEETC_CORE_DEVICE_QUERY_MESH_KERNELS_HPP

#include "meetc/cuda/table.hpp"

namespace meetc::on_device {

// ---- the corners ----

// Numbers for the corners of n elements, whose rows are these: equal where their coordinates are, 0 and -0 too. `cells`: 2^bits
// numbers, more than there are corners.
cudaError_t number_corners(const float *rows, std::uint32_t n, std::uint32_t *cells, int bits, std::uint32_t *numbers,
                           cudaStream_t stream);
// The same by three vertices of each of the caller's elements; vertices null: no two corners have one number.
cudaError_t name_corners(const std::uint32_t *vertices, const std::uint32_t *order, std::uint32_t n,
                         std::uint32_t *numbers, cudaStream_t stream);

// Row orders_of_corners i + k of `to` is row i with its corners in order k.
inline constexpr std::uint32_t orders_of_corners = 6;
MEETC_HD constexpr int corner_in_order(int order, int i) {
  const int first = order / 2, second = (first + 1 + order % 2) % 3;
  return i == 0 ? first : i == 1 ? second : 3 - first - second;
}
MEETC_HD constexpr int order_with(int first, int second) {
  return 2 * first + ((first + 1) % 3 == second ? 0 : 1);
}
cudaError_t order_corners(const float *rows, std::uint32_t n, float *to, cudaStream_t stream);

// ---- elements without an extent ----

struct flat_element {
  std::uint32_t element;
  float row[9];
};
// Those that may be so (core/views/collinear.hpp), in any order. *count is 0 before.
cudaError_t find_flat(const float *rows, const std::uint32_t *order, std::uint32_t n, flat_element *found,
                      unsigned *count, cudaStream_t stream);

// ---- the candidates ----

struct sorting_job {
  cuda::pair_list candidates; // pairs of slots
  const std::uint32_t *numbers, *order;
  const std::uint32_t *owner; // by element; null: each is its own item
  // Without a common corner: pairs of slots. With one, two, and three: pairs of rows with their common corners first, all three
  // of them in `three`. In each, the first is of the lesser element. Their lists are as long as that of the candidates.
  cuda::pair_list apart, one, two, three;
  unsigned long long *three_count;
};
// Pairs of one item, and an element with itself, are left out.
cudaError_t sort_by_corners(const sorting_job &job, cudaStream_t stream);
// Makes pairs of slots again of the pairs of such rows.
cudaError_t to_slots(const cuda::pair_list &rows, cudaStream_t stream);

} // namespace meetc::on_device

#endif
