// The kernels that cull two sets and depend on no kind of element, on the host: see stand_in.cpp.
#include "core/device/cull_kernels.hpp"
#include "tests/runtime/device/stand_in_rows.hpp"

#include <meetc/cull_grid.hpp>

namespace meetc {
namespace {

struct vertex {
  static constexpr int fields = 3;
  static constexpr role role_of(int field) { return field == 0 ? role::x : field == 1 ? role::y : role::z; }
  static bool obeys(const float *) { return true; }
};
template <class Take> void each_vertex(const vertices_of_two &v, int set, Take &&take) {
  cuda::view vertices = v.of[set];
  vertices.index = nullptr;
  for (std::uint32_t i = 0; i < vertices.vertices; ++i) {
    float point[3];
    const bool there = stand_in::posed_element<vertex>(vertices, v.at[set], i, point);
    take(i, point, there);
  }
}

} // namespace

cudaError_t surround_vertices(const vertices_of_two &v, cuda::joined_box *around, cudaStream_t) {
  for (int set = 0; set < 2; ++set)
    each_vertex(v, set, [&](std::size_t, const float *point, bool there) {
      for (int k = 0; k < 3 && there; ++k) {
        around[set].below[k] = std::max(around[set].below[k], cuda::below_of(point[k]));
        around[set].above[k] = std::max(around[set].above[k], cuda::above_of(point[k]));
      }
    });
  return cudaSuccess;
}
cudaError_t find_cells(const vertices_of_two &v, const cuda::joined_box *around, int bits, const vertex_cells &cells,
                       cudaStream_t) {
  const cuda::cull_grid grid(around[0], around[1], bits);
  for (int set = 0; set < 2; ++set)
    each_vertex(v, set, [&](std::size_t i, const float *point, bool there) {
      cells.of[set][i] = there ? grid.cells_of(point).bits : cuda::no_cells;
    });
  return cudaSuccess;
}

} // namespace meetc
