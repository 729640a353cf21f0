// core/device/tree.hpp: a hierarchy of boxes over a set on a device, made there.
//
// Problem: the pairs of groups grow with the product of the sets. Method: the elements are sorted along Hilbert's curve,
// and every 32 of them, and every 32 nodes, get a node (meetc/tree.hpp). The order is made once for a set; after a pose
// only the boxes are.
#ifndef MEETC_CORE_DEVICE_TREE_HPP
#define MEETC_CORE_DEVICE_TREE_HPP

#include "core/device/memory.hpp"
#include "meetc/tree_order.hpp"

namespace meetc {

// What ordering a set needs for a while.
struct order_scratch {
  device_memory<std::uint32_t> counts;
  device_memory<cuda::place_rank> places;
  device_memory<std::byte> space;
};

class device_tree {
public:
  // The tree over n >= 1 rows on the device. `around` is their extent; where slots of earlier rows have been ordered, their
  // order stays. Enqueues work, which needs the scratch memory until it is done, and throws device_error.
  void make(const cuda::kind_launchers &kind, const float *rows, std::uint32_t n, const extent *around,
            order_scratch &scratch, cudaStream_t stream);

  bool is_made() const { return nodes_.capacity() > 0; }
  cuda::tree_view view(std::uint32_t n) const { return {nodes_.data(), slots_.data(), n, cuda::tree_shape(n)}; }

private:
  void order(const cuda::kind_launchers &kind, const float *rows, std::uint32_t n, const extent *around,
             order_scratch &scratch, cudaStream_t stream);

  device_memory<std::uint32_t> slots_;
  device_memory<cuda::tree_node> nodes_;
};

} // namespace meetc

#endif
