// core/device/memory/blocks.hpp: how many blocks the engine's own kernels are started with.
#ifndef MEETC_CORE_DEVICE_MEMORY_BLOCKS_HPP
#define MEETC_CORE_DEVICE_MEMORY_BLOCKS_HPP

#include <cstddef>

namespace meetc {

inline constexpr unsigned threads = 256; // of a block

// A thread for each of n, up to a number beyond which threads take several.
inline unsigned blocks_for(std::size_t n) {
  const std::size_t blocks = (n + threads - 1) / threads;
  return static_cast<unsigned>(blocks < 65536 ? blocks : 65536);
}

} // namespace meetc

#endif
