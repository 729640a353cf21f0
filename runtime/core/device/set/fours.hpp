// core/device/set/fours.hpp: the hierarchy by fours of a set on a device (meetc/volume/fours.hpp), made there.
#ifndef MEETC_CORE_DEVICE_SET_FOURS_HPP
#define MEETC_CORE_DEVICE_SET_FOURS_HPP

#include "meet/core/device/memory/memory.hpp"
#include "meetc/volume/fours.hpp"

#include <optional>

namespace meetc {

class device_fours {
public:
  // Over the elements of a tree on the device; none where there are too many, or too little memory. Enqueues work, and
  // throws device_error.
  std::optional<cuda::fours_view> make(const cuda::tree_view &tree, cudaStream_t stream);

private:
  device_memory<cuda::four_boxes> nodes_;
};

} // namespace meetc

#endif
