#include "core/device/tree.hpp"

#include "core/device/tree_kernels.hpp"

namespace meetc {
namespace {

// Bits of a place along an axis. There are up to eight elements for each cell of a set that fills space, and more for one
// that lies on a surface; those that share a cell about keep the order that they had.
int place_bits(std::uint32_t n) {
  return n <= std::uint32_t{1} << 18 ? 5 : n <= std::uint32_t{1} << 21 ? 6 : 7;
}

} // namespace

void device_tree::make(const cuda::kind_launchers &kind, const float *rows, std::uint32_t n, const extent *around,
                       order_scratch &scratch, cudaStream_t stream) {
  if (!is_made()) {
    order(kind, rows, n, around, scratch, stream);
    nodes_.reserve(cuda::tree_shape(n).nodes(), "a hierarchy");
  }
  check(kind.boxes(rows, n, slots_.data(), nodes_.data(), stream), "starting a kernel");
  check(enclose_levels(nodes_.data(), n, stream), "starting a kernel");
}

void device_tree::order(const cuda::kind_launchers &kind, const float *rows, std::uint32_t n, const extent *around,
                        order_scratch &scratch, cudaStream_t stream) {
  const int bits = place_bits(n);
  const std::uint32_t cells = std::uint32_t{1} << 3 * bits;
  std::size_t bytes = 0;
  check(order_slots(nullptr, bytes, nullptr, cells, nullptr, n, nullptr, stream), "planning to order");
  scratch.counts.reserve(cells, "the order of a set");
  scratch.places.reserve(n, "the order of a set");
  scratch.space.reserve(bytes, "the order of a set");
  slots_.reserve(n, "the order of a set");
  check(cudaMemsetAsync(scratch.counts.data(), 0, cells * sizeof(std::uint32_t), stream), "clearing counters");
  check(kind.places(rows, n, around, bits, scratch.counts.data(), scratch.places.data(), stream), "starting a kernel");
  check(order_slots(scratch.space.data(), bytes, scratch.counts.data(), cells, scratch.places.data(), n, slots_.data(),
                    stream),
        "ordering a set");
}

} // namespace meetc
