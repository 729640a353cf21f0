// core/device/set/tree.hpp: a hierarchy of boxes over a set on a device, made there.
//
// Problem: most pairs of two sets are far apart, and to look at each costs the product of their sizes. Method: a set's rows
// are in a spatial order, and every 32 of them, and every 32 nodes, get a node (meetc/volume/tree.hpp). After a pose the boxes
// are made again; the order stays.
#ifndef MEETC_CORE_DEVICE_SET_TREE_HPP
#define MEETC_CORE_DEVICE_SET_TREE_HPP

#include "meet/core/device/memory/memory.hpp"

namespace meetc {

class device_tree {
public:
  // The tree over n >= 1 rows on the device. Enqueues work, and throws device_error.
  void make(const cuda::set_launchers &kind, const float *rows, std::uint32_t n, cudaStream_t stream);

  // Takes the memory of the tree over n rows, if it is there.
  void take_room(std::uint32_t n, cudaStream_t stream) { nodes_.grow(cuda::tree_shape(n).nodes(), 0, stream); }
  // That memory; null where it is not there.
  cuda::tree_node *room(std::uint32_t n) {
    return nodes_.capacity() >= cuda::tree_shape(n).nodes() ? nodes_.data() : nullptr;
  }
  // A number that the kernels which make a small tree leave as it is, 0. Throws device_error.
  unsigned *arrived(cudaStream_t stream);

  cuda::tree_view view(std::uint32_t n) const { return {nodes_.data(), n, cuda::tree_shape(n)}; }

private:
  device_memory<cuda::tree_node> nodes_;
  device_memory<unsigned> arrived_; // for the kernel that makes a small tree
};

} // namespace meetc

#endif
